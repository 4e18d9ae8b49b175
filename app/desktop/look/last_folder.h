// The folders in which dialogs begin: where the person was last.
#pragma once

#include <QString>

namespace bole::desktop {

// `purpose`: "open", "save", "export", ...; each has its own folder. Empty before the first time, and when it is gone.
QString last_folder(const QString& purpose);
// `path` is the file or folder that was chosen; gives it back, so that a dialog can be wrapped: empty stays empty.
QString note_folder(const QString& purpose, const QString& path);
// `name` in that folder, as a dialog that saves takes it.
QString in_last_folder(const QString& purpose, const QString& name);

}  // namespace bole::desktop
