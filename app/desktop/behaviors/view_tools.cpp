#include "behaviors/view_tools.h"

#include <algorithm>

#include "main_window.h"
#include "panels/view_panel.h"
#include "views/scene_view.h"

namespace bole::desktop {
namespace {

QAction* add_switch(MainWindow& window, const char* id, const QString& text, const QKeySequence& key,
                    bool ViewSettings::*member) {
  auto& scene = window.scene();
  auto* action = window.add_action(
      window.menu(Menu::view), id, text, [] {}, key);
  action->setCheckable(true);
  QObject::connect(action, &QAction::toggled, &window, [&scene, member](bool on) {
    auto settings = scene.settings();
    if (settings.*member == on) return;
    settings.*member = on;
    scene.set_settings(settings);
    Q_EMIT scene.settings_changed();
  });
  QObject::connect(&scene, &SceneView::settings_changed, action,
                   [&scene, action, member] { action->setChecked(scene.settings().*member); });
  return action;
}

void change_point_size(SceneView& scene, double by) {
  auto settings = scene.settings();
  settings.point_size_px = std::clamp(settings.point_size_px + by, 1.0, 12.0);
  scene.set_settings(settings);
  Q_EMIT scene.settings_changed();
}

}  // namespace

void install_view_tools(MainWindow& window) {
  auto* panel = new ViewPanel(window.scene(), &window);
  window.docks().add("view", MainWindow::tr("View"), panel, Qt::LeftDockWidgetArea, "options");
  auto* menu = window.menu(Menu::view);
  auto& scene = window.scene();
  menu->addSeparator();
  add_switch(window, "eye_dome", MainWindow::tr("Eye-dome shading"), Qt::Key_E, &ViewSettings::eye_dome);
  add_switch(window, "grid", MainWindow::tr("Grid in metres"), Qt::Key_G, &ViewSettings::grid);
  auto* clip = window.add_action(
      menu, "clip_box", MainWindow::tr("Clip box"), [] {}, Qt::Key_B);
  clip->setCheckable(true);
  QObject::connect(clip, &QAction::toggled, panel, [panel, &scene](bool on) {
    if (scene.settings().clip.has_value() != on) panel->set_clip(on);
  });
  QObject::connect(&scene, &SceneView::settings_changed, clip,
                   [&scene, clip] { clip->setChecked(scene.settings().clip.has_value()); });
  window.add_action(
      menu, "clip_reset", MainWindow::tr("Clip box around everything"), [panel] { panel->reset_clip(); },
      QKeySequence("Shift+B"));
  window.add_action(
      menu, "all_heights", MainWindow::tr("All heights"), [panel] { panel->reset_heights(); }, QKeySequence("Shift+H"));
  window.add_action(
      menu, "larger_points", MainWindow::tr("Larger points"), [&scene] { change_point_size(scene, 1); }, Qt::Key_Plus);
  window.add_action(
      menu, "smaller_points", MainWindow::tr("Smaller points"), [&scene] { change_point_size(scene, -1); },
      Qt::Key_Minus);
  window.add_action(
      menu, "view_dock", MainWindow::tr("Look of the view…"), [&window] { window.docks().raise("view"); }, Qt::Key_V);
}

}  // namespace bole::desktop
