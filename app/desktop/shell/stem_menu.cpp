#include "behaviors/review_behavior.h"
#include "main_window.h"
#include "panels/table_panel.h"
#include "shell/menus.h"
#include "views/scene_view.h"
#include "views/slice_view.h"

namespace bole::desktop {

void make_stem_menu(MainWindow& window) {
  auto* menu = window.menu(Menu::stem);
  auto* w = &window;
  w->add_action(
      menu, "next_stem", MainWindow::tr("Next doubtful stem"), [w] { w->review().next(); }, QKeySequence("Ctrl+Right"));
  w->add_action(
      menu, "previous_stem", MainWindow::tr("Previous doubtful stem"), [w] { w->review().previous(); },
      QKeySequence("Ctrl+Left"));
  w->add_action(
      menu, "zoom_to_stem", MainWindow::tr("Zoom to the selected stem"),
      [w] {
        if (w->selection().tree()) w->scene().zoom_to_tree(*w->selection().tree());
      },
      Qt::Key_Z);
  menu->addSeparator();
  menu->addActions(w->stems().actions());
  auto* add = w->add_action(
      menu, "add_tree", MainWindow::tr("Add a tree by a circle"), [] {}, Qt::Key_C);
  add->setCheckable(true);
  QObject::connect(add, &QAction::toggled, &w->slice(), &SliceView::set_adding);
  QObject::connect(&w->slice(), &SliceView::adding_changed, add, &QAction::setChecked);
}

}  // namespace bole::desktop
