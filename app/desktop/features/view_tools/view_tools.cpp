// The look of the 3-D view: the dock "View", directions, colours, heights, clip box, shading, grid, size of points.
#include <QMenu>
#include <algorithm>

#include "features/view_tools/bookmarks.h"
#include "features/view_tools/export_image.h"
#include "features/view_tools/fly.h"
#include "features/view_tools/plan_map.h"
#include "features/view_tools/plot_boundary.h"
#include "features/view_tools/view_panel.h"
#include "look/array_words.h"
#include "views/scene_view.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

constexpr int camera_section = 0, look_section = 1;  // of the menu View
constexpr double min_point_px = 1, max_point_px = 12;

template <class Change>
void change_settings(SceneView& scene, Change change) {
  auto settings = scene.settings();
  change(settings);
  scene.set_settings(settings);
  Q_EMIT scene.settings_changed();
}

void change_point_size(SceneView& scene, double by) {
  change_settings(scene, [by](ViewSettings& settings) {
    settings.point_size_px = std::clamp(settings.point_size_px + by, min_point_px, max_point_px);
  });
}

void fill_colors(QMenu& menu, SceneView& scene) {
  for (const auto& array : scene.colorable())
    QObject::connect(menu.addAction(array_words(array)), &QAction::triggered, &scene,
                     [&scene, array] { scene.color_by(array); });
}

void add_camera_commands(Workbench& bench) {
  auto& scene = bench.scene();
  auto& commands = bench.commands();
  commands.add_submenu({.id = "view.colors",
                        .title = Workbench::tr("Colour points by"),
                        .place = in_menu(Menu::view, camera_section),
                        .fill = [&scene](QMenu& menu) { fill_colors(menu, scene); }});
  const auto add = [&](const char* id, const QString& text, int key, const std::function<void()>& act) {
    commands.add({.id = id,
                  .text = text,
                  .key = QKeySequence(key),
                  .places = {in_menu(Menu::view, camera_section), in_tool_bar("view_bar"), in_context("scene")},
                  .act = act});
  };
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(), z = Eigen::Vector3d::UnitZ();
  add("view.all", Workbench::tr("Whole survey"), Qt::Key_0, [&scene] { scene.reset_camera(); });
  add("view.above", Workbench::tr("From above"), Qt::Key_8, [&scene, y, z] { scene.look_along(-z, y); });
  add("view.north", Workbench::tr("From the north"), Qt::Key_9, [&scene, y, z] { scene.look_along(-y, z); });
  add("view.south", Workbench::tr("From the south"), Qt::Key_2, [&scene, y, z] { scene.look_along(y, z); });
  add("view.west", Workbench::tr("From the west"), Qt::Key_4, [&scene, x, z] { scene.look_along(x, z); });
  add("view.east", Workbench::tr("From the east"), Qt::Key_6, [&scene, x, z] { scene.look_along(-x, z); });
  commands.add({.id = "view.parallel",
                .text = Workbench::tr("Parallel projection"),
                .key = Qt::Key_5,
                .places = {in_menu(Menu::view, camera_section), in_tool_bar("view_bar", 1), in_context("scene")},
                .turn = [&scene](bool on) { scene.set_parallel(on); },
                .checked_when = [&scene] { return scene.parallel(); }});
}

void add_switch(Workbench& bench, const char* id, const QString& text, const QKeySequence& key,
                bool ViewSettings::*member) {
  auto& scene = bench.scene();
  bench.commands().add(
      {.id = id,
       .text = text,
       .key = key,
       .places = {in_menu(Menu::view, look_section), in_tool_bar("view_bar", 1)},
       .turn = [&scene,
                member](bool on) { change_settings(scene, [=](ViewSettings& settings) { settings.*member = on; }); },
       .checked_when = [&scene, member] { return scene.settings().*member; }});
}

void add_terrain_switch(Workbench& bench) {
  auto& scene = bench.scene();
  bench.commands().add(
      {.id = "view.terrain",
       .text = Workbench::tr("Terrain with contour lines"),
       .key = QKeySequence("Shift+L"),
       .places = {in_menu(Menu::view, look_section), in_tool_bar("view_bar", 1)},
       .turn = [&scene](bool on) { change_settings(scene, [=](ViewSettings& settings) { settings.terrain = on; }); },
       .enabled_when = {[&scene] { return scene.survey().terrain != nullptr; },
                        Workbench::tr("The survey has no terrain model yet.")},
       .checked_when = [&scene] { return scene.survey().terrain != nullptr && scene.settings().terrain; }});
}

void add_look_commands(Workbench& bench, ViewPanel* panel) {
  auto& scene = bench.scene();
  add_switch(bench, "view.eye_dome", Workbench::tr("Eye-dome shading"), Qt::Key_E, &ViewSettings::eye_dome);
  add_switch(bench, "view.grid", Workbench::tr("Grid in metres"), Qt::Key_G, &ViewSettings::grid);
  add_terrain_switch(bench);
  add_switch(bench, "view.trees", Workbench::tr("Tree numbers"), Qt::Key_T, &ViewSettings::trees);
  bench.commands().add({.id = "view.clip_box",
                        .text = Workbench::tr("Clip box"),
                        .key = Qt::Key_B,
                        .places = {in_menu(Menu::view, look_section), in_tool_bar("view_bar", 1)},
                        .turn = [panel](bool on) { panel->set_clip(on); },
                        .checked_when = [&scene] { return scene.settings().clip.has_value(); }});
  const auto add = [&](const char* id, const QString& text, const QKeySequence& key, const std::function<void()>& act) {
    bench.commands().add(
        {.id = id, .text = text, .key = key, .places = {in_menu(Menu::view, look_section)}, .act = act});
  };
  add("view.clip_reset", Workbench::tr("Clip box around everything"), QKeySequence("Shift+B"),
      [panel] { panel->reset_clip(); });
  add("view.all_heights", Workbench::tr("All heights"), QKeySequence("Shift+H"), [panel] { panel->reset_heights(); });
  add("view.larger_points", Workbench::tr("Larger points"), Qt::Key_Plus, [&scene] { change_point_size(scene, 1); });
  add("view.smaller_points", Workbench::tr("Smaller points"), Qt::Key_Minus,
      [&scene] { change_point_size(scene, -1); });
  add("view.dock", Workbench::tr("Look of the view…"), Qt::Key_V, [b = &bench] { b->docks().raise("view"); });
}

}  // namespace

void install_view_tools(Workbench& bench) {
  auto* panel = new ViewPanel(bench.scene(), &bench);
  bench.docks().add("view", Workbench::tr("View"), panel, Qt::LeftDockWidgetArea, "options");
  add_camera_commands(bench);
  auto* b = &bench;
  QObject::connect(&bench.scene(), &SceneView::menu_asked, b,
                   [b](const QPoint& global) { b->commands().show_menu("scene", global); });
  add_look_commands(bench, panel);
  new PlanMap(bench);
  new Fly(bench);
  new PlotBoundary(bench);
  new Bookmarks(bench);
  add_image_export(bench);
}

}  // namespace bole::desktop
