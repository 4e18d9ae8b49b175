#include "shell/recent_files.h"

#include <QFileInfo>
#include <QSettings>

namespace bole::desktop {
namespace {
constexpr int max_files = 10;
}

void note_recent_file(const QString& path) {
  QStringList files = recent_files();
  const QString full = QFileInfo(path).absoluteFilePath();
  files.removeAll(full);
  files.prepend(full);
  QSettings().setValue("recent_files", QStringList(files.mid(0, max_files)));
}

QStringList recent_files() { return QSettings().value("recent_files").toStringList(); }

}  // namespace bole::desktop
