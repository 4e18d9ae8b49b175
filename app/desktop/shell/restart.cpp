#include "shell/restart.h"

#include <QApplication>
#include <QSettings>

#include "look/language.h"
#include "shell/main_window.h"

namespace bole::desktop {
namespace {

constexpr const char *language_setting = "language", *reopen_setting = "reopen";

}  // namespace

void restart_in_language(MainWindow& window, const QString& code) {
  if (code == current_language()) return;
  QApplication::setQuitOnLastWindowClosed(false);
  if (window.close()) {
    QSettings().setValue(language_setting, code);
    QSettings().setValue(reopen_setting, window.session().path());
    QCoreApplication::exit(restart_code);
  }
  QApplication::setQuitOnLastWindowClosed(true);
}

QString take_file_to_reopen() {
  QSettings settings;
  const QString path = settings.value(reopen_setting).toString();
  settings.remove(reopen_setting);
  return path;
}

}  // namespace bole::desktop
