// Documents with changes that were not saved when the program ended: they are offered at the next start.
#pragma once

#include <QString>
#include <QStringList>

namespace bole::desktop {

void note_unsaved(const QString& path);    // by this process
void forget_unsaved(const QString& path);  // saved, or the changes were given up

// Those whose recovery file (Session::recovery_path) is there and whose program does not run any more.
QStringList unsaved_documents();

}  // namespace bole::desktop
