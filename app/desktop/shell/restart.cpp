#include "shell/restart.h"

#include <QApplication>
#include <QFileInfo>
#include <QSettings>
#include <utility>
#include <vector>

#include "base/atomic_file.h"
#include "look/language.h"
#include "panels/log_panel.h"
#include "shell/main_window.h"

namespace bole::desktop {
namespace {

constexpr const char *language_setting = "language", *reopen_setting = "reopen", *results_setting = "reopen_results";

// What the log of the window before had, for the next one of this process.
std::vector<LogLine>& told_before() {
  static std::vector<LogLine> lines;
  return lines;
}

// What is not in the file of the document goes where a crash would leave it: the next window takes it from there.
void keep_for_the_next_window(const Session& session) {
  if (session.changed() || session.recovered() || !QFileInfo::exists(session.path()))
    write_text_file(Session::recovery_path(session.path()).toStdString(), session.document().to_json());
  QSettings().setValue(reopen_setting, session.path());
}

}  // namespace

void restart_in_language(MainWindow& window, const QString& code) {
  if (code == current_language()) return;
  QApplication::setQuitOnLastWindowClosed(false);
  if (window.session().has_document()) keep_for_the_next_window(window.session());
  window.close_without_question();
  if (window.close()) {
    told_before() = window.log().all_lines();
    QSettings().setValue(language_setting, code);
    QSettings().setValue(results_setting, !window.runner().survey().empty());
    QCoreApplication::exit(restart_code);
  }
  QApplication::setQuitOnLastWindowClosed(true);
}

bool reopen(MainWindow& window) {
  for (const auto& line : std::exchange(told_before(), {})) window.log().add(line);
  QSettings settings;
  const QString path = settings.value(reopen_setting).toString();
  const bool results = settings.value(results_setting).toBool();
  settings.remove(reopen_setting);
  settings.remove(results_setting);
  if (path.isEmpty()) return false;
  if (QFileInfo::exists(Session::recovery_path(path)))
    window.restore(path);
  else
    window.open(path);
  if (results) window.refresh();
  return true;
}

}  // namespace bole::desktop
