// File > Open recent.
#pragma once

#include <QString>
#include <QStringList>

namespace bole::desktop {

class MainWindow;

void note_recent_file(const QString& path);
QStringList recent_files();  // the latest first, at most ten
void make_recent_menu(MainWindow& window);

}  // namespace bole::desktop
