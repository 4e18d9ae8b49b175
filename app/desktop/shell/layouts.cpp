#include "shell/layouts.h"

#include <QDockWidget>
#include <QInputDialog>
#include <QMenu>
#include <QSettings>
#include <QTimer>

#include "shell/main_window.h"
#include "shell/modes.h"
#include "shell/shell_commands.h"

namespace bole::desktop {
namespace {

constexpr int state_version = 2;  // raised when docks change so that saved layouts do not fit

void apply_layout(MainWindow* window, const QString& name) {
  window->restoreState(QSettings().value("layouts/" + name).toByteArray(), state_version);
}

void fill_layouts(MainWindow* window, QMenu& menu) {
  QSettings settings;
  settings.beginGroup("layouts");
  for (const auto& name : settings.childKeys())
    QObject::connect(menu.addAction(name), &QAction::triggered, window, [window, name] { apply_layout(window, name); });
}

void fill_deletions(MainWindow* window, QMenu& menu) {
  QSettings settings;
  settings.beginGroup("layouts");
  for (const auto& name : settings.childKeys())
    QObject::connect(menu.addAction(name), &QAction::triggered, window,
                     [name] { QSettings().remove("layouts/" + name); });
}

void save_layout(MainWindow* window) {
  const QString name = QInputDialog::getText(window, MainWindow::tr("Save layout"), MainWindow::tr("Name"));
  if (!name.isEmpty())
    QSettings().setValue("layouts/" + QString(name).replace('/', '-'), window->saveState(state_version));
}

// Panels with a window of their own were shown while the main window was not: window managers keep such ones below it.
void show_panels_above(MainWindow& window) {
  for (auto* dock : window.docks().all()) {
    if (!dock->isFloating() || !dock->isVisible()) continue;
    dock->hide();
    QTimer::singleShot(0, dock, &QDockWidget::show);
  }
}

}  // namespace

void add_layout_menus(MainWindow& window) {
  auto* w = &window;
  auto& commands = window.commands();
  commands.add_submenu({.id = "panel.menu",
                        .title = MainWindow::tr("Panels"),
                        .place = in_menu(Menu::view, window_section),
                        .fill = [w](QMenu& menu) {
                          for (auto* dock : w->docks().all()) menu.addAction(dock->toggleViewAction());
                        }});
  commands.add_submenu({.id = "layout.menu",
                        .title = MainWindow::tr("Layouts"),
                        .place = in_menu(Menu::view, window_section),
                        .fill = [w](QMenu& menu) { fill_layouts(w, menu); }});
  commands.add(
      {.id = "layout.save", .text = MainWindow::tr("Save layout…"), .places = {in_submenu("layout.menu")}, .act = [w] {
         save_layout(w);
       }});
  commands.add_submenu({.id = "layout.delete_menu",
                        .title = MainWindow::tr("Delete layout"),
                        .place = in_submenu("layout.menu"),
                        .fill = [w](QMenu& menu) { fill_deletions(w, menu); }});
}

void restore_last_layout(MainWindow& window) {
  const QSettings settings;
  const auto modes = shipped_modes();
  const QString last = settings.value("mode").toString();
  auto mode = modes.front();
  for (const auto& m : modes)
    if (m.id == last) mode = m;
  apply_mode(window, mode);
  window.restoreGeometry(settings.value("geometry").toByteArray());
  window.restoreState(settings.value("state").toByteArray(), state_version);
  show_panels_above(window);
}

void keep_layout(MainWindow& window) {
  QSettings settings;
  settings.setValue("geometry", window.saveGeometry());
  settings.setValue("state", window.saveState(state_version));
}

}  // namespace bole::desktop
