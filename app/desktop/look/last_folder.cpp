#include "look/last_folder.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>

namespace bole::desktop {

QString last_folder(const QString& purpose) {
  const QString folder = QSettings().value("folders/" + purpose).toString();
  return QFileInfo(folder).isDir() ? folder : QString();
}

QString note_folder(const QString& purpose, const QString& path) {
  if (!path.isEmpty()) QSettings().setValue("folders/" + purpose, QFileInfo(path).absolutePath());
  return path;
}

QString in_last_folder(const QString& purpose, const QString& name) {
  const QString folder = last_folder(purpose);
  return folder.isEmpty() ? name : QDir(folder).filePath(name);
}

}  // namespace bole::desktop
