#include "features/traits/plant_editor.h"

#include <Eigen/Geometry>
#include <QInputDialog>
#include <QVariant>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "document/edit_list.h"
#include "features/traits/plant_form.h"
#include "render/charts/columns.h"
#include "views/scene_view.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

using PlantAction = plant::PlantEdit::Action;

const std::string handle_layer = "plant_handles";
const QString base_id = "base", height_id = "stem_height";
constexpr double cross_m = 0.012, min_ring_m = 0.006, min_height = 0.001, max_height = 10;
constexpr double min_value_mm = 0.01, max_value_mm = 1e5;

// Far below what can be measured or clicked: edits stay short texts.
Eigen::Vector3d rounded(const Eigen::Vector3d& place) { return (place * 1e5).array().round() / 1e5; }

plant::PlantEdit plant_edit(PlantAction action) {
  plant::PlantEdit edit;
  edit.action = action;
  return edit;
}

}  // namespace

PlantEditor::PlantEditor(Workbench& bench, PlantForm& form) : QObject(&bench), bench_(bench), form_(form) {
  make_commands();
  auto& scene = bench_.scene();
  connect(&bench_, &Workbench::survey_shown, this, &PlantEditor::show_survey);
  connect(&form_, &PlantForm::apply_asked, this, [this] { bench_.guarded([this] { apply_form(); }); });
  connect(&scene, &SceneView::place_taken, this, [this](const Eigen::Vector3d& place, const QVariant& point) {
    if (task_ != Task::base) return;
    if (point.isNull()) return bench_.say(tr("There is no point here. Click one that is drawn."));
    stop();
    bench_.guarded([&] { set_base(place); });
  });
  connect(&scene, &SceneView::outline_taken, this, [this](const SceneOutline& outline) {
    if (task_ == Task::outline) bench_.guarded([&] { take_outline(outline); });
  });
  connect(&scene, &SceneView::grip_dragged, this,
          [this](const QString& layer, int drawing, int, const Eigen::Vector3d& at, bool released) {
            if (layer.toStdString() == handle_layer)
              bench_.guarded([&] { drag(drawing == 0 ? base_id : height_id, at, released); });
          });
  connect(&scene, &SceneView::place_taker_changed, this, [this](const QObject* taker) {
    if (taker == this || !task_) return;
    task_.reset();
    bench_.hint({});
    bench_.commands().update();
  });
}

void PlantEditor::add_tool(const char* id, const QString& text, const QString& short_text, const char* key, Task task) {
  const When ready{[this] { return measured(); }, tr("Run a pipeline first that measures a plant and takes edits.")};
  bench_.commands()
      .add({.id = id,
            .text = text,
            .key = QKeySequence(key),
            .places = {in_submenu("plant.menu"), in_context("plant")},
            .turn = [this, task](bool on) { on ? start(task) : stop(); },
            .enabled_when = ready,
            .checked_when = [this, task] { return task_ == task; }})
      ->setIconText(short_text);
}

void PlantEditor::make_commands() {
  auto& commands = bench_.commands();
  const When ready{[this] { return measured(); }, tr("Run a pipeline first that measures a plant and takes edits.")};
  const std::vector<Place> places{in_submenu("plant.menu"), in_context("plant")};
  commands.add_submenu({.id = "plant.menu", .title = tr("Plant"), .place = in_menu(Menu::tools, 1)});
  const auto add = [&](const char* id, const QString& text, const QString& short_text, const char* key,
                       const std::function<void()>& act, const When& when) {
    commands
        .add({.id = id, .text = text, .key = QKeySequence(key), .places = places, .act = act, .enabled_when = when})
        ->setIconText(short_text);
  };
  add_tool("plant.pick_base", tr("Set the base of the stem by a click"), tr("Click"), "Shift+F", Task::base);
  commands
      .add({.id = "plant.handles",
            .text = tr("Handles of base and height of measurement"),
            .key = QKeySequence("Shift+E"),
            .places = places,
            .turn = [this](bool on) { show_handles(on); },
            .enabled_when = ready,
            .checked_when = [this] { return handles_; }})
      ->setIconText(tr("Handles"));
  add_tool("plant.outline", tr("Cut off what an outline goes around"), tr("Outline"), "Shift+C", Task::outline);
  add("plant.cut_box", tr("Cut off what lies in the clip box"), tr("Clip box"), "Shift+X",
      [this] {
        const auto& box = *bench_.scene().settings().clip;
        PointRegion region;
        region.kind = PointRegion::Kind::box;
        region.min = box.lo;
        region.max = box.hi;
        cut(region);
      },
      {[this] { return measured() && bench_.scene().settings().clip.has_value(); },
       tr("Measure a plant and set a clip box around the points first.")});
  add(
      "plant.accept", tr("Accept the plant"), tr("Accept"), "Shift+A", [this] { decide(PlantAction::accept); }, ready);
  add(
      "plant.reject", tr("Reject the plant"), tr("Reject"), "Shift+R", [this] { decide(PlantAction::reject); }, ready);
  add(
      "plant.set_value", tr("Give a measured value…"), tr("Value…"), "Shift+V", [this] { ask_for_value(); }, ready);
  add(
      "plant.note", tr("Note on the plant…"), tr("Note…"), "",
      [this] {
        bool given = false;
        const auto text = QInputDialog::getText(&bench_, tr("Note"), tr("Note"), QLineEdit::Normal, {}, &given);
        if (given) decide(PlantAction::note, text.toStdString());
      },
      ready);
  form_.add_buttons(commands);
  commands.give_context_menu(form_, "plant");
}

// Of what is shown: conditions of commands are asked before this feature hears of another survey.
bool PlantEditor::measured() const {
  const auto& survey = bench_.runner().survey();
  return survey.traits && survey.traits->rows() > 0 && survey.points && plant_can_be_edited(bench_.session());
}

double PlantEditor::stem_height_mm() const {
  const auto values =
      survey_.traits ? render::numbers_or_nan(*survey_.traits, "stem_height_mm") : std::vector<double>();
  return values.empty() ? std::numeric_limits<double>::quiet_NaN() : values.front();
}

void PlantEditor::show_survey(const Survey& survey) {
  survey_ = survey;
  places_ = trait_places(survey);
  base_ = places_.base;
  height_mm_ = stem_height_mm();
  if (!measured()) stop();
  form_.show_places(measured() ? base_ : std::nullopt, height_mm_);
  form_.show_state(survey);
  draw();
}

void PlantEditor::set_base(const Eigen::Vector3d& base) {
  auto edit = plant_edit(PlantAction::set_base);
  edit.at = rounded(base);
  add_edits(bench_.session(), {edit});
}

void PlantEditor::set_stem_height(double height) {
  auto edit = plant_edit(PlantAction::set_stem_height);
  edit.height = std::clamp(std::round(height * 1e5) / 1e5, min_height, max_height);
  add_edits(bench_.session(), {edit});
}

// Points are cut off the plant alone: what lies behind it stays what it is.
void PlantEditor::cut(const PointRegion& region) {
  auto edit = plant_edit(PlantAction::assign);
  edit.region = region;
  edit.part = form_.cut_becomes();
  if (edit.part != plant::Part::plant) edit.from = plant::Part::plant;
  add_edits(bench_.session(), {edit});
}

void PlantEditor::give_value(const std::string& trait, double value_mm) {
  auto edit = plant_edit(PlantAction::set_value);
  edit.trait = trait;
  edit.value_mm = value_mm;
  const auto now = render::numbers_or_nan(*survey_.traits, trait + "_mm");
  if (!now.empty() && std::isfinite(now.front())) edit.was_mm = now.front();
  add_edits(bench_.session(), {edit});
}

void PlantEditor::decide(PlantAction action, const std::string& note) {
  auto edit = plant_edit(action);
  edit.text = note;
  add_edits(bench_.session(), {edit});
}

// Both places of the form are one step of undo.
void PlantEditor::apply_form() {
  std::vector<plant::PlantEdit> edits;
  if (const auto base = form_.new_base()) {
    edits.push_back(plant_edit(PlantAction::set_base));
    edits.back().at = *base;
  }
  if (const auto mm = form_.new_stem_height_mm()) {
    edits.push_back(plant_edit(PlantAction::set_stem_height));
    edits.back().height = *mm / 1000;
  }
  if (!edits.empty()) add_edits(bench_.session(), edits);
}

void PlantEditor::ask_for_value() {
  const QStringList names{tr("Height"), tr("Breadth, length"), tr("Breadth, width"), tr("Diameter of the stem")};
  constexpr const char* traits[] = {"height", "breadth_length", "breadth_width", "stem_diameter"};
  bool given = false;
  const QString name =
      QInputDialog::getItem(&bench_, tr("Trait"), tr("What was measured by hand"), names, 0, false, &given);
  if (!given) return;
  const std::string trait = traits[names.indexOf(name)];
  const auto now = render::numbers_or_nan(*survey_.traits, trait + "_mm");
  const double before = !now.empty() && std::isfinite(now.front()) ? now.front() : 1;
  const double mm =
      QInputDialog::getDouble(&bench_, name, tr("Value in mm"), before, min_value_mm, max_value_mm, 2, &given);
  if (given) give_value(trait, mm);
}

void PlantEditor::start(Task task) {
  if (!measured()) throw bad_input("no plant is measured", "a run of a pipeline with a stage that edits traits");
  task_ = task;
  bench_.scene().set_place_taker(this, task == Task::outline ? SceneView::Takes::outlines : SceneView::Takes::places);
  bench_.hint(task == Task::base ? tr("Click the foot of the stem, where it leaves the soil.")
                                 : tr("Draw around the points with the left mouse button. Escape ends it."));
  bench_.commands().update();
}

void PlantEditor::stop() {
  if (task_) bench_.scene().set_place_taker(nullptr);
}

void PlantEditor::take_outline(const SceneOutline& outline) {
  PointRegion region;
  region.kind = PointRegion::Kind::outline;
  for (const auto& corner : outline.corners) region.outline.push_back(rounded(corner));
  if (outline.eye) region.eye = rounded(*outline.eye);
  stop();
  cut(region);
}

void PlantEditor::show_handles(bool on) {
  handles_ = on;
  draw();
}

double PlantEditor::height_of(const Eigen::Vector3d& place) const { return places_.up.dot(place - *places_.base); }

Eigen::Vector3d PlantEditor::on_soil(const Eigen::Vector3d& place) const {
  try {
    const auto scene = plant::scene_of(survey_.points->facts);
    return place + (scene.soil_height_at(place) - scene.up.dot(place)) * scene.up;
  } catch (const Error&) {
    return place;  // points that tell nothing of the soil
  }
}

// On the axis of the stem where it is known, else above its base.
Eigen::Vector3d PlantEditor::stem_at(double height) const {
  const auto& axis = places_.axis;
  for (std::size_t i = 1; places_.base && i < axis.size(); ++i) {
    const double a = height_of(axis[i - 1]), b = height_of(axis[i]);
    if (a != b && std::min(a, b) <= height && height <= std::max(a, b))
      return axis[i - 1] + (height - a) / (b - a) * (axis[i] - axis[i - 1]);
  }
  return *base_ + height * places_.up;
}

void PlantEditor::drag(const QString& id, const Eigen::Vector3d& at, bool released) {
  if (!measured() || !places_.base) return;
  if (id == base_id)
    base_ = on_soil(at);
  else
    height_mm_ = 1000 * std::clamp(height_of(at), min_height, max_height);
  draw();
  if (!released) return;
  if (id == base_id && (*base_ - *places_.base).norm() > 1e-4) return set_base(*base_);
  if (id == height_id && std::abs(height_mm_ - stem_height_mm()) > 0.05) return set_stem_height(height_mm_ / 1000);
}

void PlantEditor::draw() {
  std::vector<SceneDrawing> drawings;
  if (handles_ && measured() && base_ && std::isfinite(height_mm_)) {
    const Eigen::Vector3d u = places_.up.unitOrthogonal(), v = places_.up.cross(u);
    SceneDrawing base;
    base.id = base_id.toStdString();
    for (const auto& side : {u, v}) base.lines.push_back({*base_ - cross_m * side, *base_ + cross_m * side});
    base.grips = {*base_};
    base.strong = true;
    SceneDrawing height;
    height.id = height_id.toStdString();
    const Eigen::Vector3d on_stem = stem_at(height_mm_ / 1000);
    height.lines = {ring_about(on_stem, places_.up, min_ring_m), {*base_, on_stem}};
    height.grips = {on_stem};
    height.rail = places_.up;
    if (std::abs(height_mm_ - stem_height_mm()) > 0.05) {  // while it is dragged
      height.label = QString::number(height_mm_, 'f', 1).toStdString() + " mm";
      height.label_at = on_stem - 6 * min_ring_m * u;
    }
    height.strong = true;
    drawings = {std::move(base), std::move(height)};
  }
  bench_.scene().set_drawings(handle_layer, std::move(drawings));
}

}  // namespace bole::desktop
