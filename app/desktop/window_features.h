// The list of what the window can do beyond opening, running and showing. A feature is a function that adds its docks,
// actions and connections through the public face of MainWindow; it keeps its objects as children of the window.
#pragma once

namespace bole::desktop {

class MainWindow;

void install_features(MainWindow& window);

}  // namespace bole::desktop
