#include "document/unsaved.h"

#include <signal.h>

#include <QCoreApplication>
#include <QFileInfo>
#include <QSettings>
#include <QVariantMap>
#include <cerrno>

#include "document/session.h"

namespace bole::desktop {
namespace {

constexpr const char* unsaved_setting = "unsaved_documents";  // path -> id of the process that has it open

QVariantMap noted() { return QSettings().value(unsaved_setting).toMap(); }

bool runs(qint64 process) {
  if (process == QCoreApplication::applicationPid()) return false;  // a document of ours is in hand, or was given up
  return process > 0 && (kill(static_cast<pid_t>(process), 0) == 0 || errno == EPERM);
}

}  // namespace

void note_unsaved(const QString& path) {
  auto all = noted();
  const QString full = QFileInfo(path).absoluteFilePath();
  const QVariant own = QCoreApplication::applicationPid();
  if (all.value(full) == own) return;
  all[full] = own;
  QSettings().setValue(unsaved_setting, all);
}

void forget_unsaved(const QString& path) {
  auto all = noted();
  if (all.remove(QFileInfo(path).absoluteFilePath()) > 0) QSettings().setValue(unsaved_setting, all);
}

QStringList unsaved_documents() {
  QStringList found;
  const auto all = noted();
  for (auto it = all.begin(); it != all.end(); ++it) {
    if (!QFileInfo::exists(Session::recovery_path(it.key())))
      forget_unsaved(it.key());
    else if (!runs(it.value().toLongLong()))
      found << it.key();
  }
  return found;
}

}  // namespace bole::desktop
