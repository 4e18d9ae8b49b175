// The dock "View" and its actions: colours, heights, clip box, shading, grid, size of points.
#pragma once

namespace bole::desktop {

class MainWindow;

void install_view_tools(MainWindow& window);

}  // namespace bole::desktop
