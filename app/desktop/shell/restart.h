// A change of the language closes the window, which may ask to save, and makes a new one.
#pragma once

#include <QString>

namespace bole::desktop {

class MainWindow;

inline constexpr int restart_code = 77;  // with which the event loop ends then

void restart_in_language(MainWindow& window, const QString& code);
QString take_file_to_reopen();  // what was open before, once; empty: nothing

}  // namespace bole::desktop
