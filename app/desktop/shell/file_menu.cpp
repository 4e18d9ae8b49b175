#include <QDesktopServices>
#include <QFileDialog>
#include <QFileInfo>
#include <QStatusBar>
#include <QUrl>

#include "behaviors/sample_behavior.h"
#include "main_window.h"
#include "shell/menus.h"
#include "shell/recent_files.h"

namespace bole::desktop {
namespace {

QString pipelines() { return MainWindow::tr("Pipelines (*.json)"); }

void make_open_actions(MainWindow* w, QMenu* menu) {
  w->add_action(
      menu, "open", MainWindow::tr("Open…"),
      [w] {
        const QString path = QFileDialog::getOpenFileName(
            w, MainWindow::tr("Open"), {},
            MainWindow::tr("Pipelines, clouds, scans") +
                " (*.json *.las *.laz *.ply *.pcd *.xyz *.txt *.csv *.pcap);;" + pipelines());
        if (!path.isEmpty()) w->open(path);
      },
      QKeySequence::Open);
  w->add_action(menu, "open_sample", MainWindow::tr("Open sample plot"), [w] { w->open_sample(); });
  make_recent_menu(*w);
  auto* sample = &w->sample();
  QObject::connect(sample, &SampleBehavior::progressed, w, [w](double, const QString& what) {
    w->statusBar()->showMessage(MainWindow::tr("Making the sample plot: %1").arg(what));
  });
  QObject::connect(sample, &SampleBehavior::failed, w, &MainWindow::complain);
}

void make_save_actions(MainWindow* w, QMenu* menu) {
  w->add_action(
      menu, "save", MainWindow::tr("Save pipeline"),
      [w] {
        if (w->session().has_document()) w->save(w->session().path());
      },
      QKeySequence::Save);
  w->add_action(
      menu, "save_as", MainWindow::tr("Save pipeline as…"),
      [w] {
        const QString path =
            QFileDialog::getSaveFileName(w, MainWindow::tr("Save pipeline"), w->session().path(), pipelines());
        if (!path.isEmpty()) w->save(path);
      },
      QKeySequence::SaveAs);
}

void make_export_actions(MainWindow* w, QMenu* menu) {
  w->add_action(
      menu, "export", MainWindow::tr("Export survey and report…"),
      [w] {
        if (!w->session().has_document()) throw bad_input("no pipeline is open", "one that was run");
        const QString folder =
            QFileDialog::getExistingDirectory(w, MainWindow::tr("Export survey and report"), w->results_folder());
        if (!folder.isEmpty()) w->export_to(folder);
      },
      QKeySequence("Ctrl+E"));
  w->add_action(menu, "open_report", MainWindow::tr("Open report"), [w] {
    const QString report = w->last_export() + "/report.html";
    if (!QFileInfo::exists(report))
      throw bad_input("there is no report yet", "a run of the whole pipeline", "Press Run, or export the survey");
    QDesktopServices::openUrl(QUrl::fromLocalFile(report));
  });
}

}  // namespace

void make_file_menu(MainWindow& window) {
  auto* menu = window.menu(Menu::file);
  make_open_actions(&window, menu);
  menu->addSeparator();
  make_save_actions(&window, menu);
  menu->addSeparator();
  make_export_actions(&window, menu);
  menu->addSeparator();
  window.add_action(
      menu, "quit", MainWindow::tr("Quit"), [w = &window] { w->close(); }, QKeySequence::Quit);
}

void make_edit_menu(MainWindow& window) {
  auto& stack = window.session().undo_stack();
  auto* undo = stack.createUndoAction(&window, MainWindow::tr("Undo"));
  auto* redo = stack.createRedoAction(&window, MainWindow::tr("Redo"));
  undo->setObjectName("undo");
  redo->setObjectName("redo");
  undo->setShortcut(QKeySequence::Undo);
  redo->setShortcut(QKeySequence::Redo);
  window.menu(Menu::edit)->addActions({undo, redo});
}

}  // namespace bole::desktop
