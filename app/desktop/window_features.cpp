#include "window_features.h"

#include "behaviors/figure_export.h"
#include "behaviors/measure_behavior.h"
#include "behaviors/row_behavior.h"
#include "behaviors/view_tools.h"
#include "behaviors/running_feature.h"
#include "features/field_check/field_check.h"

namespace bole::desktop {

// One line for each feature, in the order in which their actions appear in the menus.
void install_features(MainWindow& window) {
  install_view_tools(window);
  install_measuring(window);
  install_rows(window);
  install_figure_export(window);
  install_running(window);
  install_field_check(window);
}

}  // namespace bole::desktop
