#include "features/view_tools/plan_map.h"

#include "views/scene_view.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

constexpr int map_section = 0;         // of the menu View
constexpr double stems_below_m = 3.0;  // heights above ground that a map shows

}  // namespace

PlanMap::PlanMap(Workbench& bench) : QObject(&bench), bench_(bench) {
  bench_.commands().add(
      {.id = "view.map",
       .text = tr("Plan map"),
       .key = Qt::Key_7,
       .places = {in_menu(Menu::view, map_section), in_tool_bar("view_bar"), in_context("scene")},
       .turn = [this](bool on) { turn(on); },
       .enabled_when = {[this] { return bench_.scene().has_survey(); }, tr("Open a scan or a point cloud first.")},
       .checked_when = [this] { return on(); },
       .tip = tr("From above, north up, with tree numbers; drag to move")});
  connect(&bench_, &Workbench::document_opened, this, [this] {
    before_.reset();
    bench_.scene().set_flat(false);
    bench_.commands().update();
  });
  // A map tells where north is.
  connect(&bench_.scene(), &SceneView::map_changed, this, [this] {
    if (on() && !bench_.scene().north().isApprox(north_)) look_down();
  });
}

void PlanMap::look_down() {
  north_ = bench_.scene().north();
  bench_.scene().look_along(-Eigen::Vector3d::UnitZ(), {north_.x(), north_.y(), 0});
}

void PlanMap::turn(bool on) {
  if (on == this->on()) return;
  auto& scene = bench_.scene();
  scene.set_flat(on);
  if (!on) {
    const auto before = *std::exchange(before_, std::nullopt);
    auto settings = scene.settings();  // colours and sizes that were chosen on the map stay
    settings.trees = before.settings.trees;
    settings.grid = before.settings.grid;
    settings.filter = before.settings.filter;
    scene.set_settings(settings);
    scene.set_view_point(before.point);
  } else {
    before_ = Before{scene.settings(), scene.view_point()};
    auto settings = scene.settings();
    settings.trees = settings.grid = true;
    const auto& points = scene.survey().points;
    if (points && points->has(arrays::height_above_ground)) settings.filter.height.hi = stems_below_m;
    scene.set_settings(settings);
    scene.set_parallel(true);
    look_down();
  }
  Q_EMIT scene.settings_changed();
}

}  // namespace bole::desktop
