#include "shell/recent_files.h"

#include <QFileInfo>
#include <QSettings>

#include "main_window.h"

namespace bole::desktop {
namespace {
constexpr int most = 10;
}

void note_recent_file(const QString& path) {
  QStringList files = recent_files();
  const QString full = QFileInfo(path).absoluteFilePath();
  files.removeAll(full);
  files.prepend(full);
  QSettings().setValue("recent_files", QStringList(files.mid(0, most)));
}

QStringList recent_files() { return QSettings().value("recent_files").toStringList(); }

void make_recent_menu(MainWindow& window) {
  auto* w = &window;
  auto* menu = window.menu(Menu::file)->addMenu(MainWindow::tr("Open recent"));
  const auto fill = [w, menu] {
    menu->clear();
    for (const auto& path : recent_files()) {
      auto* action = menu->addAction(QFileInfo(path).fileName());
      action->setToolTip(path);
      action->setEnabled(QFileInfo::exists(path));
      QObject::connect(action, &QAction::triggered, w, [w, path] { w->guarded([&] { w->open(path); }); });
    }
    menu->setEnabled(!menu->isEmpty());
  };
  menu->setToolTipsVisible(true);
  QObject::connect(window.menu(Menu::file), &QMenu::aboutToShow, menu, fill);
  fill();
}

}  // namespace bole::desktop
