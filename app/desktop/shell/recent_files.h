// The files that were opened last.
#pragma once

#include <QString>
#include <QStringList>

namespace bole::desktop {

void note_recent_file(const QString& path);
QStringList recent_files();  // the latest first, at most ten

}  // namespace bole::desktop
