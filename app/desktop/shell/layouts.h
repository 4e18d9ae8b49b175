// Where docks and bars stand: kept from one start to the next, and saved under names in View > Layouts.
#pragma once

class QSettings;

namespace bole::desktop {

class MainWindow;

// The mode's own when there is none. Before the window is shown; panels with windows of their own come after it.
void restore_last_layout(MainWindow& window);
void keep_layout(MainWindow& window);

}  // namespace bole::desktop
