#include "window_features.h"

namespace bole::desktop {

// One line for each feature, in the order in which their actions appear in the menus.
void install_features(MainWindow&) {}

}  // namespace bole::desktop
