// The tool bars: commands that stand in_tool_bar("run_bar") and so on, as icons.
#pragma once

namespace bole::desktop {

class MainWindow;

void make_tool_bars(MainWindow& window);

}  // namespace bole::desktop
