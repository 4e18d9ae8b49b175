// Help > Keys and menus (F1): a sheet made from the actions of the window themselves.
#pragma once

#include <QString>
#include <vector>

namespace bole::desktop {

class MainWindow;

struct ShortcutLine {
  QString menu, text, key;
};
// Every action in the menus that has a key, and those of panels, in the order of the menus.
std::vector<ShortcutLine> shortcut_lines(MainWindow& window);

void make_help_menu(MainWindow& window);

}  // namespace bole::desktop
