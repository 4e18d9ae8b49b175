// Help > Keys (F1): a sheet made from the registered commands.
#pragma once

#include <QString>
#include <vector>

namespace bole::desktop {

class MainWindow;

struct ShortcutLine {
  QString menu, text, key;
};
// Every command with a key: those of the menus in their order, then those of panels.
std::vector<ShortcutLine> shortcut_lines(MainWindow& window);

}  // namespace bole::desktop
