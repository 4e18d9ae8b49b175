#include "features/section/section.h"

#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSignalBlocker>
#include <QTimer>
#include <algorithm>
#include <cmath>
#include <utility>

#include "document/rows/row_cut.h"
#include "views/scene_view.h"
#include "views/section_view.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

const std::string section_layer = "section", measured_layer = "measurements";
constexpr double shortest_line_m = 0.05, line_above_ground_m = 0.05;
constexpr int cut_after_ms = 30;

}  // namespace

SectionTool::SectionTool(Workbench& bench)
    : QObject(&bench), bench_(bench), view_(new SectionView(&bench)), where_(new QLabel), soon_(new QTimer(this)) {
  make_commands();
  make_dock();
  soon_->setSingleShot(true);
  connect(soon_, &QTimer::timeout, this, [this] { cut(!std::exchange(moved_, false)); });
  auto& scene = bench_.scene();
  connect(&bench_, &Workbench::document_opened, this, &SectionTool::clear);
  connect(&bench_, &Workbench::preview_shown, this, [this] {
    survey_ = bench_.scene().survey();
    cut_soon();
  });
  connect(&bench_, &Workbench::survey_shown, this, [this](const Survey& survey) {
    survey_ = bench_.visibility().survey_for(ViewKind::cuts, survey);
    cut_soon();
  });
  connect(&scene, &SceneView::settings_changed, this, &SectionTool::cut_soon);
  connect(&scene, &SceneView::index_built, this, &SectionTool::cut_soon);
  connect(&scene, &SceneView::clouds_changed, this, &SectionTool::cut_soon);
  connect(&scene, &SceneView::drawings_changed, this, [this](const QString& layer) {
    if (layer.toStdString() == measured_layer) draw_measurements();
  });
  connect(&scene, &SceneView::place_taken, this, [this](const Eigen::Vector3d& place) {
    if (drawing_) bench_.guarded([&] { take(place); });
  });
  connect(&scene, &SceneView::place_taker_changed, this, [this](const QObject* taker) {
    if (taker == this || !drawing_) return;
    drawing_ = false;
    first_.reset();
    bench_.hint({});
    bench_.commands().update();
    draw_in_scene();
  });
  connect(&scene, &SceneView::grip_dragged, this,
          [this](const QString& layer, int, int grip, const Eigen::Vector3d& at, bool released) {
            if (layer.toStdString() == section_layer) drag(grip, at, released);
          });
  connect(&bench_.selection(), &Selection::changed, this,
          [this] { view_->select(bench_.selection().tree().value_or(0)); });
  connect(view_, &SectionView::clicked, this, &SectionTool::click);
  join_point_tools();
}

// What takes outlines and strokes in the 3-D view takes them here too. An outline is one of both.
void SectionTool::join_point_tools() {
  auto& scene = bench_.scene();
  connect(&scene, &SceneView::place_taker_changed, this, [this] {
    using Takes = SceneView::Takes;
    const auto takes = bench_.scene().takes();
    view_->set_takes(takes == Takes::corners   ? SectionView::Takes::corners
                     : takes == Takes::strokes ? SectionView::Takes::strokes
                                               : SectionView::Takes::places);
  });
  connect(&scene, &SceneView::outline_dropped, this, [this] {
    if (!outlines_) view_->drop_outline();
  });
  connect(&scene, &SceneView::outline_taken, this, [this] {
    if (!outlines_) view_->drop_outline();
  });
  connect(&scene, &SceneView::points_marked, this, [this] { view_->mark_points(bench_.scene().marked_points()); });
  connect(view_, &SectionView::outline_begun, this, [this] {
    outlines_ = true;
    bench_.scene().drop_outline();
    outlines_ = false;
  });
  connect(view_, &SectionView::outline_drawn, this, &SectionTool::take_outline);
  connect(view_, &SectionView::stroke_drawn, this, &SectionTool::take_stroke);
  connect(view_, &SectionView::stroke_ended, &scene, &SceneView::stroke_ended);
}

// In the plane of the section, as wide as it: what is not shown is not meant.
void SectionTool::take_outline(const std::vector<Eigen::Vector2d>& corners) {
  if (!line_) return;
  SceneOutline outline;
  for (const auto& corner : corners) {
    const double along_m = std::clamp(corner.x(), 0.0, line_->length_m());
    const Eigen::Vector2d plan = line_->from + along_m * line_->direction();
    outline.corners.emplace_back(plan.x(), plan.y(), corner.y());
  }
  outline.half_depth_m = line_->width_m / 2;
  outlines_ = true;
  Q_EMIT bench_.scene().outline_taken(outline);
  outlines_ = false;
}

void SectionTool::take_stroke(std::uint32_t point, bool begins) {
  const auto& section = view_->section();
  if (!section || section->owners[point] != 0 || !cut_.points) return;
  Q_EMIT bench_.scene().stroke_taken(cut_.points->position(section->indices[point]), begins);
}

void SectionTool::draw_line(bool on) {
  drawing_ = on;
  first_.reset();
  bench_.scene().set_place_taker(on ? this : nullptr);
  bench_.commands().update();
  bench_.hint(on ? tr("Click where the section begins, on the left.") : QString());
}

void SectionTool::take(const Eigen::Vector3d& place) {
  const Eigen::Vector2d plan = place.head<2>();
  if (!first_) {
    first_ = plan;
    bench_.hint(tr("Click where the section ends."));
    return draw_in_scene();
  }
  if ((plan - *first_).norm() < shortest_line_m) return bench_.say(tr("The line is too short. Click its end again."));
  const SectionLine line{*first_, plan, width_->value()};
  draw_line(false);
  show(line);
}

void SectionTool::show(const SectionLine& line) {
  path_.clear();
  put(line, false);
  bench_.docks().raise("section");
}

void SectionTool::put(const SectionLine& line, bool keep_sight) {
  line_ = line;
  view_->drop_outline();
  moved_ = !keep_sight;
  const QSignalBlocker quiet_width(width_), quiet_length(length_);
  width_->setValue(line.width_m);
  length_->setValue(line.length_m());
  draw_in_scene();
  show_where();
  bench_.commands().update();
  cut_soon();
}

void SectionTool::drag(int grip, const Eigen::Vector3d& at, bool released) {
  if (!line_) return;
  SectionLine line = *line_;
  (grip == 0 ? line.from : line.to) = at.head<2>();
  if (line.length_m() < shortest_line_m) return draw_in_scene();
  path_.clear();
  put(line, !released);
}

void SectionTool::follow(std::vector<Eigen::Vector2d> path) {
  if (path_length_m(path) < shortest_line_m)
    throw bad_input("the path is shorter than " + std::to_string(shortest_line_m) + " m",
                    "a walk or a row with a length");
  path_ = std::move(path);
  put_on_path(0);
  bench_.docks().raise("section");
}

void SectionTool::put_on_path(double at_m) {
  const auto line = line_across(path_, at_m, length_->value() / 2, width_->value());
  if (!line) return bench_.hint(tr("The path ends here."));
  const bool keep = line_.has_value();
  at_m_ = at_m;
  put(*line, keep);
}

void SectionTool::across_walk() {
  if (!survey_.walk || survey_.walk->poses.size() < 2)
    throw bad_input("the survey has no walk", "a scan that was recorded while walking");
  std::vector<Eigen::Vector2d> path;
  for (const auto& pose : survey_.walk->poses) path.emplace_back(pose.T_target_sensor.translation().head<2>());
  follow(std::move(path));
}

std::vector<Eigen::Vector2d> SectionTool::selected_row() const {
  const auto id = bench_.selection().row();
  if (!id || !survey_.rows) throw bad_input("no row is selected", "one row of plants", "Click it in the table of rows");
  auto path = row_course(survey_, *id);
  if (path.empty())
    throw bad_input("row " + *id + " is not in the table of rows", "one that is", "Run the pipeline again");
  return path;
}

void SectionTool::across_row() { follow(selected_row()); }

void SectionTool::along_row() {
  const auto row = selected_row();
  show({row.front(), row.back(), width_->value()});
}

void SectionTool::step(int by) {
  if (!line_) return;
  if (path_.empty())
    put(line_->shifted(by * line_->width_m), true);
  else
    put_on_path(at_m_ + by * line_->width_m);
}

void SectionTool::clear() {
  line_.reset();
  cut_ = {};
  path_.clear();
  view_->show_section({}, false);
  dock_->hide();
  draw_in_scene();
  show_where();
  bench_.commands().update();
}

void SectionTool::cut_soon() {
  if (line_) soon_->start(cut_after_ms);  // steps that come fast are cut once
}

void SectionTool::cut(bool keep_sight) {
  if (!line_) return;
  view_->set_point_size(bench_.scene().settings().point_size_px);
  if (!survey_.points) survey_ = bench_.scene().survey();
  show_cut(survey_, keep_sight);
  if ((survey_.index && survey_.index->disk()) || !beside_on_disk().empty()) ask_disk();
}

std::vector<SceneCloud> SectionTool::beside_on_disk() const {
  std::vector<SceneCloud> found;
  for (const auto& cloud : bench_.scene().clouds())
    if (cloud.disk()) found.push_back(cloud);
  return found;
}

void SectionTool::show_cut(const Survey& of, bool keep_sight, const Slab& slab) {
  auto& scene = bench_.scene();
  cut_ = of;
  beside_.clear();
  beside_ids_.clear();
  for (const auto& cloud : scene.clouds()) {
    beside_ids_.push_back(cloud.id);
    beside_.push_back(section_cloud(cloud, scene.paint()));
    if (const auto read = slab.beside.find(cloud.id); read != slab.beside.end()) beside_.back().points = read->second;
  }
  view_->show_section(cut_through(cut_, *line_, scene.paint(), scene.stem_shapes(), beside_), keep_sight);
  view_->select(bench_.selection().tree().value_or(0));
  draw_in_scene();
  draw_measurements();
  show_where();
}

// The coarse points are shown until those of the slab have been read.
void SectionTool::ask_disk() {
  if (!std::exchange(reads_disk_, true))
    slabs_.start([this](const std::stop_token& stop, const auto& answer) {
      while (const auto wish = slabs_.next(stop)) read_slab(*wish, stop, answer);
    });
  slabs_.ask({survey_.index ? survey_.index->disk() : nullptr, *line_, beside_on_disk()});
}

// In a thread of its own.
void SectionTool::read_slab(const SlabWish& wish, const std::stop_token& stop,
                            const LastWish<SlabWish>::Answer& answer) {
  try {
    Run run;
    run.cancel = stop;
    Slab slab;
    if (wish.disk) slab.survey = slab_from_disk(*wish.disk, wish.line, run);
    for (const auto& cloud : wish.beside) {
      slab.beside[cloud.id] = std::make_shared<const PointCloud>(
          render::placed_cloud(*slab_from_disk(*cloud.disk(), own_line(cloud, wish.line), run), cloud.place));
    }
    answer([this, slab = std::move(slab), wish] { take_slab(wish, slab); });
  } catch (const std::exception& e) {
    if (!stop.stop_requested()) answer([this, text = QString::fromUtf8(e.what())] { bench_.say(text); });
  }
}

// Of another line, or of clouds that lie elsewhere by now, it is dropped.
void SectionTool::take_slab(const SlabWish& wish, const Slab& slab) {
  const auto& line = wish.line;
  const auto same = [](const SceneCloud& a, const SceneCloud& b) {
    return a.id == b.id && a.index == b.index && a.place == b.place;
  };
  const bool current = line_ && line_->from == line.from && line_->to == line.to && line_->width_m == line.width_m &&
                       (survey_.index ? survey_.index->disk() : nullptr) == wish.disk &&
                       std::ranges::equal(beside_on_disk(), wish.beside, same);
  if (!current) return;
  Survey read = survey_;
  if (slab.survey) {
    read.points = slab.survey;
    read.index.reset();
  }
  show_cut(read, true, slab);
}

// Whoever takes places gets this one; else its tree is selected.
void SectionTool::click(const std::optional<std::uint32_t>& point, std::int64_t stem) {
  auto& scene = bench_.scene();
  const auto& section = view_->section();
  const bool seen = point && section && *point < section->indices.size();
  const std::uint32_t owner = seen ? section->owners[*point] : 0, index = seen ? section->indices[*point] : 0;
  const auto& cloud = owner == 0 ? cut_.points : beside_[owner - 1].points;
  const bool known = seen && cloud && index < cloud->size();
  if (scene.place_taker() != nullptr) {
    if (!known || (owner == 0 && scene.survey().points != survey_.points))
      return bench_.say(tr("There is no point here. Click one that is drawn."));
    return scene.give_place({cloud, index}, owner == 0 ? 0 : beside_ids_[owner - 1]);
  }
  std::int64_t tree = stem;
  if (known && owner == 0 && cloud->has(arrays::tree_id))
    if (const auto of_point = cloud->values<std::int32_t>(arrays::tree_id)[index]; of_point > 0) tree = of_point;
  if (tree > 0 && survey_.row_of(tree)) bench_.selection().select(tree);
}

void SectionTool::draw_in_scene() {
  std::vector<SceneDrawing> drawings;
  const double z = bench_.scene().whole().lo.z() + line_above_ground_m;
  const auto on_ground = [z](const Eigen::Vector2d& plan) { return Eigen::Vector3d(plan.x(), plan.y(), z); };
  if (line_) {
    SceneDrawing d;
    d.id = section_layer;
    const auto near = line_->shifted(-line_->width_m / 2), far = line_->shifted(line_->width_m / 2);
    d.lines = {
        {on_ground(line_->from), on_ground(line_->to)},
        {on_ground(near.from), on_ground(near.to), on_ground(far.to), on_ground(far.from), on_ground(near.from)}};
    d.grips = {on_ground(line_->from), on_ground(line_->to)};
    d.strong = true;
    drawings.push_back(std::move(d));
  }
  if (first_) {
    SceneDrawing d;
    d.marks = {on_ground(*first_)};
    drawings.push_back(std::move(d));
  }
  bench_.scene().set_drawings(section_layer, std::move(drawings));
}

// What was measured, as far as it lies in the slab.
void SectionTool::draw_measurements() {
  if (!line_) return;
  std::vector<render::SectionMark> marks;
  for (const auto& d : bench_.scene().drawings(measured_layer)) {
    const bool within = !d.marks.empty() &&
                        std::ranges::all_of(d.marks, [&](const auto& p) { return line_->holds(p.template head<2>()); });
    if (!within) continue;
    const auto place = [&](const Eigen::Vector3d& p) {
      return Eigen::Vector2d(line_->along_and_off(p.head<2>()).x(), p.z());
    };
    render::SectionMark mark{{}, d.label, place(d.label_at), d.strong};
    for (const auto& line : d.lines) {
      mark.lines.emplace_back();
      for (const auto& p : line) mark.lines.back().push_back(place(p));
    }
    for (const auto& p : d.marks) mark.lines.push_back({place(p)});
    marks.push_back(std::move(mark));
  }
  view_->show_marks(std::move(marks));
}

void install_section(Workbench& bench) { new SectionTool(bench); }

}  // namespace bole::desktop
