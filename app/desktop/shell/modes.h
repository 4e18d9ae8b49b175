// Modes of the window (forester, teacher, expert): which docks, menus, commands and option tiers are shown. They are
// data: shell/modes.json.
#pragma once

#include <QString>
#include <QStringList>
#include <vector>

#include "base/option.h"

class QByteArray;

namespace bole::desktop {

class MainWindow;

struct Mode {
  QString id, title, help;      // in the language of the window
  QStringList docks;            // ids of those shown; "*": all
  QStringList front;            // ids of those in front of their tabs
  QStringList hidden_menus;     // as in menu_name()
  QStringList hidden_commands;  // ids
  Tier tier = Tier::basic;
};

// Throws Error{bad_input} that names the mode and the key.
std::vector<Mode> parse_modes(const QByteArray& json, const QString& language);
std::vector<Mode> shipped_modes();

void apply_mode(MainWindow& window, const Mode& mode);

}  // namespace bole::desktop
