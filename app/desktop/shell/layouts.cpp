#include "shell/layouts.h"

#include <QDockWidget>
#include <QInputDialog>
#include <QSettings>

#include "main_window.h"
#include "shell/modes.h"

namespace bole::desktop {
namespace {

constexpr int state_version = 1;  // raised when docks change so that saved layouts do not fit

void apply_layout(MainWindow* window, const QString& name) {
  window->restoreState(QSettings().value("layouts/" + name).toByteArray(), state_version);
}

void fill_layouts(MainWindow* window, QMenu* menu) {
  menu->clear();
  QSettings settings;
  settings.beginGroup("layouts");
  for (const auto& name : settings.childKeys())
    QObject::connect(menu->addAction(name), &QAction::triggered, window,
                     [window, name] { apply_layout(window, name); });
  if (!menu->isEmpty()) menu->addSeparator();
  auto* save = menu->addAction(MainWindow::tr("Save layout…"));
  save->setObjectName("save_layout");
  QObject::connect(save, &QAction::triggered, window, [window] {
    const QString name = QInputDialog::getText(window, MainWindow::tr("Save layout"), MainWindow::tr("Name"));
    if (!name.isEmpty())
      QSettings().setValue("layouts/" + QString(name).replace('/', '-'), window->saveState(state_version));
  });
  if (settings.childKeys().isEmpty()) return;
  auto* remove = menu->addMenu(MainWindow::tr("Delete layout"));
  for (const auto& name : settings.childKeys())
    QObject::connect(remove->addAction(name), &QAction::triggered, window,
                     [name] { QSettings().remove("layouts/" + name); });
}

}  // namespace

void make_layout_menu(MainWindow& window) {
  auto* w = &window;
  auto* panels = window.menu(Menu::view)->addMenu(MainWindow::tr("Panels"));
  QObject::connect(panels, &QMenu::aboutToShow, w, [w, panels] {
    panels->clear();
    for (auto* dock : w->docks().all()) panels->addAction(dock->toggleViewAction());
  });
  auto* layouts = window.menu(Menu::view)->addMenu(MainWindow::tr("Layouts"));
  QObject::connect(layouts, &QMenu::aboutToShow, w, [w, layouts] { fill_layouts(w, layouts); });
  fill_layouts(w, layouts);
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
}

void keep_layout(MainWindow& window) {
  QSettings settings;
  settings.setValue("geometry", window.saveGeometry());
  settings.setValue("state", window.saveState(state_version));
}

}  // namespace bole::desktop
