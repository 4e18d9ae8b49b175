// Where docks and bars stand: kept from one start to the next, and saved under names in View > Layouts.
#pragma once

class QSettings;

namespace bole::desktop {

class MainWindow;

void restore_last_layout(MainWindow& window);  // the mode's own when there is none
void keep_layout(MainWindow& window);

}  // namespace bole::desktop
