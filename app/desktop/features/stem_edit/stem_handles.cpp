#include "features/stem_edit/stem_handles.h"

#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "cloud/breast_height.h"
#include "document/edit_list.h"
#include "render/charts/columns.h"
#include "views/scene_view.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

using Action = stems::StemEdit::Action;

const std::string handles_layer = "stem_handles";
const std::string place_id = "place", lean_id = "lean", top_id = "top";
// Two pairs on the rim: whatever side it is seen from, one of them slides across the view.
const std::string east_id = "rim_east", north_id = "rim_north";
constexpr double lean_handle_m = 1.2;  // above breast height
constexpr double reach_m = 0.5;        // of the points beyond the circle
constexpr double max_slope = 5, first_top_m = 20, min_top_m = 1, max_top_m = 150;
constexpr double min_change_m = 0.001, min_slope_change = 0.001, min_height_change_m = 0.01;

const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();

bool is_circle(const std::string& handle) { return handle == place_id || handle == east_id || handle == north_id; }

std::string in_cm(double radius_m) { return render::fixed(200 * radius_m, 1) + " cm"; }

}  // namespace

StemHandles::StemHandles(Workbench& bench) : QObject(&bench), bench_(bench) {
  bench_.commands().add({.id = "stem.handles",
                         .text = tr("Handles on the stem in the 3-D view"),
                         .key = QKeySequence("Shift+T"),
                         .places = {in_menu(Menu::stem, 1), in_context("scene", 1)},
                         .turn = [this](bool on) { bench_.guarded([&] { show(on); }); },
                         .enabled_when = bench_.with_tree(),
                         .checked_when = [this] { return shown_; },
                         .tip = tr("Drag the middle, the rim, the lean or the top. The points correct the circle; with "
                                   "Shift it stays as it was drawn.")});
  connect(&bench_, &Workbench::survey_shown, this, &StemHandles::take_stem);
  connect(&bench_.selection(), &Selection::changed, this, &StemHandles::take_stem);
  connect(&bench_.scene(), &SceneView::grip_dragged, this,
          [this](const QString& layer, int drawing, int, const Eigen::Vector3d& at, bool released) {
            if (layer.toStdString() != handles_layer) return;
            const auto& all = bench_.scene().drawings(handles_layer);
            if (static_cast<std::size_t>(drawing) >= all.size()) return;
            const std::string handle = all[static_cast<std::size_t>(drawing)].id;  // drag() makes them anew
            bench_.guarded([&] { drag(handle, at, released); });
          });
}

void StemHandles::show(bool on) {
  if (on) check_stems_can_be_edited(bench_.session());
  shown_ = on;
  take_stem();
  if (on) bench_.hint(tr("Drag the middle, the rim, the lean or the top of the stem."));
}

void StemHandles::take_stem() {
  points_.reset();
  fit_.reset();
  stem_.reset();
  const auto& survey = bench_.runner().survey();
  if (shown_ && bench_.selection().tree() && survey.stems) stem_ = stem_place(survey, *bench_.selection().tree());
  if (stem_ && !std::isfinite(stem_->dbh_m)) stem_.reset();
  if (stem_) {
    const auto one = survey.stems->subset({stem_->row});
    const double lean = render::numbers_or_nan(one, "lean_deg")[0],
                 azimuth = render::numbers_or_nan(one, "lean_azimuth_deg")[0],
                 height = render::numbers_or_nan(one, "height_m")[0],
                 bound = render::numbers_or_nan(one, "height_lower_bound_m")[0];
    is_ = {};
    is_.breast = stem_->foot + breast_height_m(*survey.stems) * up;
    is_.radius_m = stem_->dbh_m / 2;
    if (std::isfinite(lean + azimuth))
      is_.slope = std::tan(radians(lean)) * Eigen::Vector2d(std::sin(radians(azimuth)), std::cos(radians(azimuth)));
    if (const double known = std::isfinite(height) ? height : bound; std::isfinite(known)) is_.height_m = known;
    drawn_ = is_;
  }
  draw();
}

Eigen::Vector3d StemHandles::axis_at(double above_breast_m) const {
  return drawn_.breast + above_breast_m * (up + Eigen::Vector3d(drawn_.slope.x(), drawn_.slope.y(), 0));
}

double StemHandles::top_m() const { return drawn_.height_m.value_or(first_top_m); }

void StemHandles::change(const std::string& handle, const Eigen::Vector3d& at) {
  const Eigen::Vector2d off = at.head<2>() - drawn_.breast.head<2>();
  if (handle == place_id) drawn_.breast.head<2>() = at.head<2>();
  if (handle == east_id || handle == north_id)
    drawn_.radius_m = std::clamp(off.norm(), min_drawn_radius_m, max_drawn_radius_m);
  if (handle == lean_id) {
    drawn_.slope = off / lean_handle_m;
    if (drawn_.slope.norm() > max_slope) drawn_.slope *= max_slope / drawn_.slope.norm();
  }
  if (handle == top_id) drawn_.height_m = std::clamp(at.z() - stem_->foot.z(), min_top_m, max_top_m);
}

// The points of the slice are looked up once for a drag. They are fitted across an axis of this slope.
void StemHandles::fit(const Eigen::Vector2d& slope) {
  const Eigen::Vector2d middle = is_.breast.head<2>();
  if (!points_) {
    CutPlace cut;
    cut.breast_height_m = cut.height_m = is_.breast.z() - stem_->foot.z();
    points_ = points_of_cut(bench_.runner().survey(), *stem_, cut, middle, is_.radius_m + reach_m);
  }
  render::SliceCircle circle;
  circle.centre = drawn_.breast.head<2>() - middle;
  circle.radius_m = drawn_.radius_m;
  fit_ = leaning_circle_near(*points_, circle, slope);
  if (fit_) fit_->circle.centre += middle;
}

// The circle that the points ask for across the new axis belongs to the same step. What stays as it was keeps its
// interval and its sections.
std::vector<stems::StemEdit> StemHandles::lean_edits(bool as_drawn) const {
  if ((drawn_.slope - is_.slope).norm() < min_slope_change) return {};
  stems::StemEdit tilt;
  tilt.action = Action::tilt;
  tilt.at = stem_->foot.head<2>();
  tilt.was_dbh_cm = 100 * stem_->dbh_m;
  tilt.lean_deg = degrees(std::atan(drawn_.slope.norm()));
  const double azimuth = degrees(std::atan2(drawn_.slope.x(), drawn_.slope.y()));
  tilt.lean_azimuth_deg = azimuth < 0 ? azimuth + 360 : azimuth;
  std::vector<stems::StemEdit> edits{tilt};
  if (as_drawn || !fit_) return edits;
  const double moved =
      (fit_->circle.centre - is_.breast.head<2>()).norm() + std::abs(fit_->circle.radius - is_.radius_m);
  if (moved >= min_change_m)
    for (auto& edit : circle_edits(*stem_, fit_->circle.centre, fit_->circle.radius)) edits.push_back(std::move(edit));
  return edits;
}

// The fit is taken; with Shift the circle as it was drawn.
std::vector<stems::StemEdit> StemHandles::edits(const std::string& handle, bool as_drawn) const {
  if (handle == lean_id) return lean_edits(as_drawn);
  stems::StemEdit edit;
  edit.at = stem_->foot.head<2>();
  edit.was_dbh_cm = 100 * stem_->dbh_m;
  if (handle == top_id) {
    if (is_.height_m && std::abs(top_m() - *is_.height_m) < min_height_change_m) return {};
    edit.action = Action::set_height;
    edit.height_m = top_m();
    return {edit};
  }
  const double moved = (drawn_.breast - is_.breast).norm() + std::abs(drawn_.radius_m - is_.radius_m);
  if (moved < min_change_m) return {};
  if (as_drawn || !fit_) return circle_edits(*stem_, drawn_.breast.head<2>(), drawn_.radius_m);
  return circle_edits(*stem_, fit_->circle.centre, fit_->circle.radius);
}

void StemHandles::drag(const std::string& handle, const Eigen::Vector3d& at, bool released) {
  if (!stem_) return;
  change(handle, at);
  if (is_circle(handle)) fit(Eigen::Vector2d::Zero());
  if (handle == lean_id) fit(drawn_.slope);
  if (!released) return draw();
  const auto made = edits(handle, bench_.scene().drag_keys().testFlag(Qt::ShiftModifier));
  take_stem();  // as it is until the edits are applied
  if (!made.empty()) add_edits(bench_.session(), made);
}

SceneDrawing StemHandles::handle(const std::string& id) const {
  SceneDrawing d;
  d.id = id;
  d.strong = true;
  return d;
}

std::string StemHandles::circle_words() const {
  if (!points_) return {};  // nothing is dragged
  const auto drawn = tr("drawn %1").arg(QString::fromStdString(in_cm(drawn_.radius_m)));
  const auto fitted = fit_ ? tr("fit %1").arg(QString::fromStdString(in_cm(fit_->circle.radius)))
                           : tr("no circle fits the points here");
  return (drawn + ", " + fitted).toStdString();
}

std::vector<SceneDrawing> StemHandles::drawings() const {
  SceneDrawing place = handle(place_id);
  place.lines = {ring_about(drawn_.breast, up, drawn_.radius_m)};
  if (fit_)
    place.lines.push_back(
        ring_about({fit_->circle.centre.x(), fit_->circle.centre.y(), drawn_.breast.z()}, up, fit_->circle.radius));
  place.grips = {drawn_.breast};
  place.label = circle_words();
  place.label_at = drawn_.breast + 1.5 * drawn_.radius_m * Eigen::Vector3d::UnitX();
  std::vector<SceneDrawing> all{std::move(place)};
  for (const auto& [id, side] : {std::pair(&east_id, Eigen::Vector3d(1, 0, 0)), {&north_id, {0, 1, 0}}}) {
    SceneDrawing rim = handle(*id);
    rim.grips = {drawn_.breast + drawn_.radius_m * side, drawn_.breast - drawn_.radius_m * side};
    rim.rail = side;
    all.push_back(std::move(rim));
  }
  SceneDrawing lean = handle(lean_id);
  const double ground_m = stem_->foot.z() - drawn_.breast.z();
  lean.lines = {{axis_at(ground_m), axis_at(lean_handle_m)}};
  lean.grips = {axis_at(lean_handle_m)};
  if ((drawn_.slope - is_.slope).norm() >= min_slope_change) {
    lean.label = tr("leans %1°").arg(degrees(std::atan(drawn_.slope.norm())), 0, 'f', 1).toStdString();
    lean.label_at = axis_at(lean_handle_m);
  }
  all.push_back(std::move(lean));
  SceneDrawing top = handle(top_id);
  const Eigen::Vector3d tip = axis_at(ground_m + top_m());
  top.lines = {{axis_at(lean_handle_m), tip}};
  top.grips = {tip};
  top.rail = up;
  top.label = render::fixed(top_m(), 1) + (drawn_.height_m ? " m" : " m ?");
  top.label_at = tip;
  all.push_back(std::move(top));
  return all;
}

void StemHandles::draw() {
  bench_.scene().set_drawings(handles_layer, stem_ ? drawings() : std::vector<SceneDrawing>());
}

}  // namespace bole::desktop
