#include <QFileDialog>

#include "main_window.h"
#include "shell/menus.h"

namespace bole::desktop {

void make_file_menu(MainWindow& window) {
  auto* menu = window.menu(Menu::file);
  auto* w = &window;
  const auto pipelines = [] { return MainWindow::tr("Pipelines (*.json)"); };
  w->add_action(
      menu, "open", MainWindow::tr("Open pipeline…"),
      [w, pipelines] {
        const QString path = QFileDialog::getOpenFileName(w, MainWindow::tr("Open pipeline"), {}, pipelines());
        if (!path.isEmpty()) w->open(path);
      },
      QKeySequence::Open);
  w->add_action(
      menu, "save", MainWindow::tr("Save pipeline"),
      [w] {
        if (w->session().has_document()) w->save(w->session().path());
      },
      QKeySequence::Save);
  w->add_action(
      menu, "save_as", MainWindow::tr("Save pipeline as…"),
      [w, pipelines] {
        const QString path =
            QFileDialog::getSaveFileName(w, MainWindow::tr("Save pipeline"), w->session().path(), pipelines());
        if (!path.isEmpty()) w->save(path);
      },
      QKeySequence::SaveAs);
  menu->addSeparator();
  w->add_action(
      menu, "quit", MainWindow::tr("Quit"), [w] { w->close(); }, QKeySequence::Quit);
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
