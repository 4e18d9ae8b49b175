// What the window can do with runs: jobs, the walk as it grows and its frames in time, history, comparison, scans.
#pragma once

namespace bole::desktop {

class MainWindow;

void install_running(MainWindow& window);

}  // namespace bole::desktop
