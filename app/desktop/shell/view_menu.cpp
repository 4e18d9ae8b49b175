#include <QMenu>

#include "main_window.h"
#include "shell/menus.h"
#include "views/scene_view.h"

namespace bole::desktop {
namespace {

void make_color_menu(MainWindow* w, QMenu* view) {
  auto* colors = view->addMenu(MainWindow::tr("Colour points by"));
  QObject::connect(colors, &QMenu::aboutToShow, w, [w, colors] {
    colors->clear();
    for (const auto& array : w->scene().colorable()) {
      auto* action = colors->addAction(QString::fromStdString(array).replace('_', ' '));
      QObject::connect(action, &QAction::triggered, w, [w, array] { w->scene().color_by(array); });
    }
  });
}

}  // namespace

void make_view_menu(MainWindow& window) {
  auto* menu = window.menu(Menu::view);
  auto* w = &window;
  make_color_menu(w, menu);
  const auto look = [w, menu](const char* id, const QString& text, int key, const Eigen::Vector3d& along,
                              const Eigen::Vector3d& up) {
    w->add_action(
        menu, id, text, [w, along, up] { w->scene().look_along(along, up); }, QKeySequence(key));
  };
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(), z = Eigen::Vector3d::UnitZ();
  w->add_action(
      menu, "view_all", MainWindow::tr("Whole survey"), [w] { w->scene().reset_camera(); }, Qt::Key_0);
  look("view_above", MainWindow::tr("From above"), Qt::Key_8, -z, y);
  look("view_south", MainWindow::tr("From the south"), Qt::Key_2, y, z);
  look("view_west", MainWindow::tr("From the west"), Qt::Key_4, x, z);
  look("view_east", MainWindow::tr("From the east"), Qt::Key_6, -x, z);
  auto* parallel = w->add_action(
      menu, "parallel", MainWindow::tr("Parallel projection"), [] {}, Qt::Key_5);
  parallel->setCheckable(true);
  QObject::connect(parallel, &QAction::toggled, &w->scene(), &SceneView::set_parallel);
}

}  // namespace bole::desktop
