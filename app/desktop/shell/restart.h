// A change of the language closes the window and makes a new one with the same document, its unsaved changes and its
// results.
#pragma once

#include <QString>

namespace bole::desktop {

class MainWindow;

inline constexpr int restart_code = 77;  // with which the event loop ends then

void restart_in_language(MainWindow& window, const QString& code);
// Opens what was open before the restart, once, and runs it anew where it had results: stored ones answer. False:
// nothing was. Throws bole::Error.
bool reopen(MainWindow& window);

}  // namespace bole::desktop
