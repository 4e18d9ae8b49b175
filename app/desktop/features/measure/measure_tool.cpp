#include "features/measure/measure_tool.h"

#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QVariant>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/atomic_file.h"
#include "features/measure/measure_panel.h"
#include "look/last_folder.h"
#include "stems/core/fit/circle_fit.h"
#include "views/scene_view.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

using Kind = render::Measurement::Kind;

const std::string layer = "measurements";
constexpr double slice_half_m = 0.05, start_error_m = 0.05, max_sigma_m = 0.025;  // of the fit of a ring
constexpr std::size_t min_points = 20, max_points = 4000;

QString kind_text(Kind kind) {
  switch (kind) {
    case Kind::point:
      return MeasureTool::tr("Point");
    case Kind::distance:
      return MeasureTool::tr("Distance");
    case Kind::angle:
      return MeasureTool::tr("Angle");
    case Kind::ring:
      return MeasureTool::tr("Ring");
  }
  return {};
}

QString ask(Kind kind, std::size_t clicked) {
  switch (kind) {
    case Kind::point:
      return MeasureTool::tr("Click a point.");
    case Kind::distance:
      return clicked == 0 ? MeasureTool::tr("Click where the distance begins.")
                          : MeasureTool::tr("Click where it ends.");
    case Kind::angle:
      return clicked == 0   ? MeasureTool::tr("Click a point on the first arm.")
             : clicked == 1 ? MeasureTool::tr("Click the corner.")
                            : MeasureTool::tr("Click a point on the second arm.");
    case Kind::ring:
      return MeasureTool::tr("Click point %1 of 3 on the bark; with Shift the ring is not fitted to the points around.")
          .arg(clicked + 1);
  }
  return {};
}

}  // namespace

class EditMeasurements : public SignedCommand {
 public:
  EditMeasurements(MeasureTool& tool, const QString& what, std::vector<render::Measurement> after)
      : SignedCommand(what), tool_(tool), before_(tool.list()), after_(std::move(after)) {}
  void undo() override { tool_.put(before_); }
  void redo() override { tool_.put(after_); }

 private:
  MeasureTool& tool_;
  std::vector<render::Measurement> before_, after_;
};

MeasureTool::MeasureTool(Workbench& bench) : QObject(&bench), bench_(bench), panel_(new MeasurePanel(&bench)) {
  bench_.docks().add("measurements", tr("Measurements"), panel_, Qt::RightDockWidgetArea, "profile");
  make_commands();
  connect(&bench_, &Workbench::document_opened, this, &MeasureTool::load);
  connect(&bench_, &Workbench::document_saved, this, [this] { bench_.guarded([this] { store(); }); });
  connect(&bench_.scene(), &SceneView::place_taken, this, &MeasureTool::take);
  connect(&bench_.scene(), &SceneView::place_taker_changed, this, [this](const QObject* taker) {
    if (taker == this || !tool_) return;
    tool_.reset();
    open_.reset();
    bench_.hint({});
    bench_.commands().update();
    draw();
  });
  connect(&bench_.scene(), &SceneView::drawing_clicked, this, [this](const QString& which, int drawing) {
    if (which.toStdString() == layer) select(drawing);
  });
  connect(panel_, &MeasurePanel::selection_changed, this, &MeasureTool::select);
  connect(panel_, &MeasurePanel::renamed, this, &MeasureTool::rename);
  connect(panel_, &MeasurePanel::remove_asked, this, &MeasureTool::remove);
  connect(panel_, &MeasurePanel::zoom_asked, this, [this](int which) {
    if (which >= 0) bench_.scene().zoom_to(list_[static_cast<std::size_t>(which)].points.front());
  });
  connect(panel_, &MeasurePanel::export_asked, this, [this] {
    const QString path = QFileDialog::getSaveFileName(
        &bench_, tr("Export measurements"), in_last_folder("export", "measurements.csv"), tr("Tables (*.csv)"));
    note_folder("export", path);
    if (!path.isEmpty()) bench_.guarded([&] { export_csv(path); });
  });
  panel_->show_list(list_);
}

void MeasureTool::make_commands() {
  const auto add = [&](const char* id, const QString& text, Kind kind, const QKeySequence& key) {
    bench_.commands().add({.id = id,
                           .text = text,
                           .key = key,
                           .places = {in_menu(Menu::tools), in_tool_bar("measure_bar")},
                           .turn = [this, kind](bool on) { on ? start(kind) : stop(); },
                           .checked_when = [this, kind] { return tool_ == kind; }});
  };
  add("measure.point", tr("Measure a point"), Kind::point, Qt::Key_P);
  add("measure.distance", tr("Measure a distance"), Kind::distance, Qt::Key_M);
  add("measure.angle", tr("Measure an angle"), Kind::angle, QKeySequence("Shift+M"));
  add("measure.ring", tr("Measure a diameter by three points"), Kind::ring, Qt::Key_O);
  bench_.commands().add({.id = "measure.end",
                         .text = tr("End measuring or drawing"),
                         .key = Qt::Key_Escape,
                         .places = {in_menu(Menu::tools)},
                         .act = [this] { bench_.scene().set_place_taker(nullptr); }});
}

void MeasureTool::start(Kind kind) {
  bench_.scene().set_place_taker(this);
  tool_ = kind;
  open_.reset();
  bench_.commands().update();
  bench_.hint(ask(kind, 0));
  draw();
}

void MeasureTool::stop() {
  if (tool_) bench_.scene().set_place_taker(nullptr);
}

void MeasureTool::take(const Eigen::Vector3d& place, const QVariant& point) {
  if (!tool_) return;
  if (!bench_.session().has_document()) return;
  if (point.isNull()) return bench_.say(tr("There is no point here. Click one that is drawn."));
  if (!open_) {
    open_ = *tool_ == Kind::point ? render::point_measurement(*bench_.scene().taken_cloud(), point.toUInt())
                                  : render::Measurement();
    open_->kind = *tool_;
    open_->points.clear();
  }
  open_->points.push_back(place);
  if (static_cast<int>(open_->points.size()) == render::points_needed(open_->kind)) finish();
  if (tool_) bench_.hint(ask(*tool_, open_ ? open_->points.size() : 0));
  draw();
}

void MeasureTool::finish() {
  auto done = *std::exchange(open_, std::nullopt);
  if (done.kind == Kind::ring) {
    if (!render::ring_through(done.points))
      return bench_.say(tr("The three points lie on one line. Click them around the stem."));
    if (!QGuiApplication::keyboardModifiers().testFlag(Qt::ShiftModifier)) fit_ring(done);
  }
  done.name = free_name(done.kind).toStdString();
  auto after = list_;
  after.push_back(std::move(done));
  selected_ = static_cast<int>(after.size()) - 1;
  change(tr("measure"), std::move(after));
  bench_.docks().raise("measurements");
}

// The clicked places are as good as a hand; the points of a thin layer around them know the bark better: those of the
// cloud that was clicked, which may lie beside the survey.
void MeasureTool::fit_ring(render::Measurement& ring) const {
  const auto& scene = bench_.scene();
  auto cloud_there = scene.survey().points;
  auto index = scene.survey().index;
  if (!scene.taken_from_survey()) {
    const auto beside = std::ranges::find(scene.clouds(), scene.taken_cloud(), &SceneCloud::points);
    if (beside == scene.clouds().end()) return;  // a part of a cloud on disk
    cloud_there = beside->points;
    index = beside->index;
  }
  const auto drawn = render::ring_through(ring.points);
  if (!cloud_there || !index || !drawn) return;
  const double reach = 1.3 * drawn->radius_m + start_error_m;
  const Eigen::Vector3d centre(drawn->centre.x(), drawn->centre.y(), drawn->z_m), half(reach, reach, slice_half_m);
  const auto there = index->points_at_once(cloud_there, centre - half, centre + half);
  const auto& cloud = *there.cloud;
  auto found = there.indices;
  std::ranges::sort(found);
  const std::size_t step = std::max<std::size_t>(1, found.size() / max_points);
  std::vector<Eigen::Vector2d> near;
  for (std::size_t k = 0; k < found.size(); k += step) {
    const Eigen::Vector2d p = cloud.position(found[k]).head<2>() - drawn->centre;
    if (std::abs(p.norm() - drawn->radius_m) <= start_error_m) near.push_back(p);
  }
  if (near.size() < min_points) return;
  const auto fit = stems::robust_circle(near, {Eigen::Vector2d::Zero(), drawn->radius_m}, start_error_m, max_sigma_m);
  if (!fit) return;
  ring.points.clear();
  for (const double turn : {0.0, 1.0, 2.0}) {
    const double a = turn * 2 * std::numbers::pi / 3;
    const Eigen::Vector2d at =
        drawn->centre + fit->circle.centre + fit->circle.radius * Eigen::Vector2d(std::cos(a), std::sin(a));
    ring.points.emplace_back(at.x(), at.y(), drawn->z_m);
  }
}

QString MeasureTool::free_name(Kind kind) const {
  for (int k = 1;; ++k) {
    QString name = QString("%1 %2").arg(kind_text(kind)).arg(k);
    if (std::ranges::none_of(list_, [&](const auto& m) { return m.name == name.toStdString(); })) return name;
  }
}

void MeasureTool::select(int which) {
  selected_ = which;
  panel_->select(which);
  draw();
}

void MeasureTool::remove(int which) {
  auto after = list_;
  after.erase(after.begin() + which);
  change(tr("delete a measurement"), std::move(after));
}

void MeasureTool::rename(int which, const QString& name) {
  auto after = list_;
  after[static_cast<std::size_t>(which)].name = name.toStdString();
  change(tr("rename a measurement"), std::move(after));
}

void MeasureTool::change(const QString& what, std::vector<render::Measurement> after) {
  bench_.session().undo_stack().push(new EditMeasurements(*this, what, std::move(after)));
}

void MeasureTool::put(const std::vector<render::Measurement>& list) {
  list_ = list;
  selected_ = std::min(selected_, static_cast<int>(list_.size()) - 1);
  panel_->show_list(list_);
  panel_->select(selected_);
  draw();
  bench_.guarded([this] { store(); });
}

void MeasureTool::draw() {
  std::vector<SceneDrawing> drawings;
  const auto add = [&](const render::Measurement& m, bool strong) {
    SceneDrawing d;
    d.lines = render::lines_of(m);
    d.marks = m.points;
    d.strong = strong;
    if (!render::values_of(m).empty()) {
      d.label = render::label_of(m);
      d.label_at = m.points.back();
    }
    drawings.push_back(std::move(d));
  };
  for (std::size_t i = 0; i < list_.size(); ++i) add(list_[i], static_cast<int>(i) == selected_);
  if (open_) add(*open_, true);
  bench_.scene().set_drawings(layer, std::move(drawings));
}

QString MeasureTool::file() const {
  const QFileInfo document(bench_.session().path());
  return document.dir().filePath(document.completeBaseName() + ".measurements.json");
}

void MeasureTool::load() {
  stop();
  list_.clear();
  selected_ = -1;
  unread_.clear();
  QFile stored(file());
  if (stored.open(QIODevice::ReadOnly)) try {
      list_ = render::parse_measurements(stored.readAll().toStdString());
    } catch (const Error& e) {
      unread_ = file();  // is not written over
      bench_.say(unread_ + ": " + QString::fromUtf8(e.what()));
    }
  panel_->show_list(list_);
  draw();
}

void MeasureTool::store() const {
  if (bench_.session().path().isEmpty()) return;
  if (file() == unread_)
    throw bad_input("measurements are not kept: " + unread_.toStdString() + " could not be read",
                    "a file of measurements, or none", "Move it away");
  if (list_.empty())
    QFile::remove(file());
  else
    write_text_file(file().toStdString(), render::measurements_json(list_));
}

void MeasureTool::export_csv(const QString& path) const {
  write_text_file(path.toStdString(), render::measurements_csv(list_));
}

void install_measure(Workbench& bench) { new MeasureTool(bench); }

}  // namespace bole::desktop
