#include <QDesktopServices>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QUrl>

#include "document/file_kinds.h"
#include "look/last_folder.h"
#include "shell/main_window.h"
#include "shell/recent_files.h"
#include "shell/shell_commands.h"

namespace bole::desktop {
namespace {

const QString opening = QStringLiteral("open");  // whose folder is kept
constexpr int open_section = 0, save_section = 1, export_section = 2, quit_section = 3;

QString pipelines() { return MainWindow::tr("Pipelines") + " (" + pipeline_endings() + ")"; }

void ask_and_open(MainWindow* w) {
  const QString path = QFileDialog::getOpenFileName(
      w, MainWindow::tr("Open"), last_folder(opening),
      MainWindow::tr("Pipelines, clouds, scans") + " (" + all_endings() + ");;" + pipelines());
  if (!path.isEmpty()) w->open(note_folder(opening, path));
}

// Scans and views are folders too, which a dialog for files does not give.
void ask_and_open_folder(MainWindow* w) {
  const QString path = QFileDialog::getExistingDirectory(w, MainWindow::tr("Open a folder with a scan or with views…"),
                                                         last_folder(opening));
  if (!path.isEmpty()) w->open(note_folder(opening, path));
}

void ask_and_save(MainWindow* w) {
  const QString path =
      QFileDialog::getSaveFileName(w, MainWindow::tr("Save pipeline"), w->session().path(), pipelines());
  if (!path.isEmpty()) w->save(path);
}

void ask_and_export(MainWindow* w) {
  const QString folder =
      QFileDialog::getExistingDirectory(w, MainWindow::tr("Export survey and report"), w->results_folder());
  if (!folder.isEmpty()) w->export_to(folder);
}

void open_report(MainWindow* w) {
  const QString report = w->last_export() + "/report.html";
  if (!QFileInfo::exists(report))
    throw bad_input("there is no report yet", "a run of the whole pipeline", "Press Run, or export the survey");
  if (!QDesktopServices::openUrl(QUrl::fromLocalFile(report)))
    throw failure("no program here opens " + report.toStdString(), "a browser", "Copy the path and open it elsewhere");
}

void fill_recent(MainWindow* w, QMenu& menu) {
  for (const auto& path : recent_files()) {
    auto* action = menu.addAction(QFileInfo(path).fileName());
    action->setToolTip(path);
    action->setEnabled(QFileInfo::exists(path));
    QObject::connect(action, &QAction::triggered, w, [w, path] { w->guarded([&] { w->open(path); }); });
  }
}

}  // namespace

void add_file_commands(MainWindow& window) {
  auto* w = &window;
  const auto add = [&](const char* id, const QString& text, const QKeySequence& key, int section, const When& when,
                       const std::function<void()>& act) {
    std::vector<Place> places{in_menu(Menu::file, section)};
    if (section <= save_section && std::string_view(id) != "document.save_as")
      places.push_back(in_tool_bar("file_bar"));
    w->commands().add({.id = id, .text = text, .key = key, .places = places, .act = act, .enabled_when = when});
  };
  add("document.open", MainWindow::tr("Open…"), QKeySequence::Open, open_section, {}, [w] { ask_and_open(w); });
  add("document.open_folder", MainWindow::tr("Open folder…"), QKeySequence("Ctrl+Shift+O"), open_section, {},
      [w] { ask_and_open_folder(w); });
  w->commands().add_submenu({.id = "document.recent",
                             .title = MainWindow::tr("Open recent"),
                             .place = in_menu(Menu::file, open_section),
                             .fill = [w](QMenu& menu) { fill_recent(w, menu); }});
  add("document.save", MainWindow::tr("Save pipeline"), QKeySequence::Save, save_section, w->with_document(),
      [w] { w->save(w->session().path()); });
  add("document.save_as", MainWindow::tr("Save pipeline as…"), QKeySequence::SaveAs, save_section, w->with_document(),
      [w] { ask_and_save(w); });
  add("document.export", MainWindow::tr("Export survey and report…"), QKeySequence("Ctrl+E"), export_section,
      w->with_document(), [w] { ask_and_export(w); });
  add("document.open_report", MainWindow::tr("Open report"), {}, export_section, w->with_document(),
      [w] { open_report(w); });
  add("document.quit", MainWindow::tr("Quit"), QKeySequence::Quit, quit_section, {}, [w] { w->close(); });
}

}  // namespace bole::desktop
