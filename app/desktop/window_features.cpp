#include "window_features.h"

#include "behaviors/view_tools.h"

namespace bole::desktop {

// One line for each feature, in the order in which their actions appear in the menus.
void install_features(MainWindow& window) { install_view_tools(window); }

}  // namespace bole::desktop
