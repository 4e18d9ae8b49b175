#include "features/clouds/clouds.h"

#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>
#include <algorithm>
#include <cmath>

#include "base/atomic_file.h"
#include "document/disk_memory.h"
#include "document/file_kinds.h"
#include "features/clouds/cloud_difference_page.h"
#include "features/clouds/cloud_distance.h"
#include "features/clouds/cloud_file.h"
#include "features/clouds/cloud_jobs.h"
#include "features/clouds/cloud_pairs.h"
#include "features/clouds/cloud_panel.h"
#include "look/last_folder.h"
#include "views/profile_view.h"
#include "views/scene_view.h"
#include "views/slice_view.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

const QString in_cuts_key = "clouds/in_cuts";
constexpr int place_step = 0x0c10;  // of undo, for steps that go on with one another

bool same_range(const SceneCloud& a, const SceneCloud& b) {
  if (!a.range || !b.range) return a.range.has_value() == b.range.has_value();
  return a.range->lo == b.range->lo && a.range->hi == b.range->hi && a.range_title == b.range_title;
}

// Up to a shift.
bool lies_alike(render::CloudPlace a, const render::CloudPlace& b) {
  a.shift = b.shift;
  if (a.only_shifts() && b.only_shifts()) a.pivot = b.pivot;
  return a == b;
}

}  // namespace

// A cloud comes into the list, or leaves it.
class ListCloud : public SignedCommand {
 public:
  ListCloud(Clouds& clouds, const QString& what, bool adds, std::size_t where, CloudEntry entry)
      : SignedCommand(what), clouds_(clouds), adds_(adds), where_(where), entry_(std::move(entry)) {}
  void undo() override { adds_ ? out() : in(); }
  void redo() override { adds_ ? in() : out(); }

 private:
  void in() { clouds_.insert(where_, entry_); }
  void out() { entry_ = clouds_.take_out(entry_.id); }

  Clouds& clouds_;
  bool adds_;
  std::size_t where_;
  CloudEntry entry_;
};

class PlaceCloud : public SignedCommand {
 public:
  PlaceCloud(Clouds& clouds, const CloudEntry& before, const CloudPlacing& after, const QString& what)
      : SignedCommand(what.isEmpty() ? Clouds::tr("move cloud %1").arg(before.name()) : what),
        clouds_(clouds),
        cloud_(before.id),
        typed_(what.isEmpty()),
        before_(before.at),
        after_(after) {}
  void undo() override { clouds_.put_place(cloud_, before_); }
  void redo() override { clouds_.put_place(cloud_, after_); }

  // Arrows that are held in a box are one step.
  int id() const override { return typed_ ? place_step : -1; }
  bool mergeWith(const QUndoCommand* other) override {
    const auto* next = dynamic_cast<const PlaceCloud*>(other);
    if (next == nullptr || next->cloud_ != cloud_) return false;
    after_ = next->after_;
    return true;
  }

 private:
  Clouds& clouds_;
  int cloud_;
  bool typed_;
  CloudPlacing before_, after_;
};

Clouds::Clouds(Workbench& bench) : QObject(&bench), bench_(bench) {
  in_cuts_ = QSettings().value(in_cuts_key, true).toBool();
  pairs_ = new CloudPairs(*this, bench);
  jobs_ = new CloudJobs(*this, bench);
  make_commands();
  make_align_commands();
  panel_ = new CloudPanel(*this, bench);
  OfferedFigures::of(bench_).offer([this] { return distance_figures(list_); });
  connect(&bench_, &Workbench::document_opened, this, &Clouds::load);
  connect(&bench_, &Workbench::document_saved, this, [this] { bench_.guarded([this] { store(); }); });
  connect(&bench_, &Workbench::cloud_dropped, this,
          [this](const QString& path) { bench_.guarded([&] { add(path); }); });
  connect(&bench_, &Workbench::survey_shown, this, [this] { drop_distances_from(0); });
  for (const auto signal : {&SceneView::index_built, &SceneView::settings_changed})
    connect(&bench_.scene(), signal, this, [this] {
      draw();  // how far they are may have become known
      Q_EMIT changed();
    });
  connect(&work_, &BackgroundWork::progressed, this, [this](double fraction) {
    if (fraction < fraction_ + 0.01) return;
    fraction_ = fraction;
    Q_EMIT progress();
  });
  connect(&work_, &BackgroundWork::done, this, [this] { take(std::exchange(result_, nullptr)); });
  connect(&work_, &BackgroundWork::cancelled, this, [this] { refuse({}); });
  connect(&work_, &BackgroundWork::failed, this, &Clouds::refuse);
}

void Clouds::ask_for_files() {
  const auto paths =
      QFileDialog::getOpenFileNames(&bench_, tr("Add a cloud to look at"), last_folder("open"),
                                    tr("Point clouds") + " (" + cloud_endings() + ");;" + tr("All files") + " (*)");
  for (const auto& path : paths) add(note_folder("open", path));
}

void Clouds::ask_where_to_save(int id) {
  const QString proposed = QFileInfo(find(id)->path).completeBaseName() + "_placed.laz";
  const QString path =
      QFileDialog::getSaveFileName(&bench_, tr("Save the cloud as it is shown"), in_last_folder("export", proposed),
                                   tr("Point clouds (*.laz *.las *.ply *.csv *.xyz)"));
  if (!path.isEmpty() && find(id) != nullptr) jobs_->save(id, note_folder("export", path));
}

const CloudEntry* Clouds::find(int id) const {
  const auto it = std::ranges::find(list_, id, &CloudEntry::id);
  return it == list_.end() ? nullptr : &*it;
}

CloudEntry* Clouds::entry(int id) {
  const auto it = std::ranges::find(list_, id, &CloudEntry::id);
  return it == list_.end() ? nullptr : &*it;
}

void Clouds::add(const QString& path) {
  if (!bench_.session().has_document())
    throw bad_input("nothing is open", "a survey that the cloud lies beside", "Open a scan or a point cloud first");
  wishes_.push_back({0, QFileInfo(path).absoluteFilePath()});
  panel_->come_forward();
  read_next();
}

void Clouds::read_again(int id, const QString& path) {
  auto* again = entry(id);
  if (again == nullptr) return;
  again->path = QFileInfo(path).absoluteFilePath();
  again->problem.clear();
  wishes_.push_back({id, again->path});
  read_next();
  update();
}

QString Clouds::reading_text() const {
  if (!current_) return {};
  const QString name = QFileInfo(current_->path).fileName();
  return fraction_ > 0 ? tr("Reading %1: %2 %").arg(name).arg(static_cast<int>(100 * fraction_))
                       : tr("Reading %1").arg(name);
}

void Clouds::read_next() {
  if (work_.busy() || wishes_.empty()) return;
  current_ = wishes_.front();
  wishes_.pop_front();
  dropped_ = false;
  fraction_ = 0;
  result_.reset();
  work_.start([this, path = current_->path, memory = disk_memory_bytes()](const Run& run) {
    result_ = read_cloud_to_look_at(path, memory, run);
  });
  Q_EMIT progress();
}

void Clouds::cancel_reading() {
  wishes_.clear();
  work_.cancel();
}

void Clouds::take(const std::shared_ptr<const ReadCloud>& read) {
  const auto wish = *std::exchange(current_, std::nullopt);
  if (!dropped_ && wish.id == 0) {
    CloudEntry added;
    added.id = ++last_id_;
    added.path = wish.path;
    added.color = free_cloud_color(list_);
    added.read = read;
    added.know_pivot();
    bench_.session().undo_stack().push(
        new ListCloud(*this, tr("add cloud %1").arg(added.name()), true, list_.size(), added));
    panel_->select(added.id);
    tell_if_far(added);
  } else if (auto* known = dropped_ ? nullptr : entry(wish.id)) {
    known->read = read;
    known->know_pivot();
    update();
  }
  if (!dropped_)
    for (const auto& remark : read->remarks) bench_.say(QFileInfo(wish.path).fileName() + ": " + remark);
  Q_EMIT progress();
  read_next();
}

// Of a cloud of the list nothing is lost but the sight of it.
void Clouds::refuse(const QString& why) {
  const auto wish = *std::exchange(current_, std::nullopt);
  if (!dropped_) {
    const QString text = why.isEmpty() ? tr("Its reading was cancelled.") : why;
    if (auto* known = entry(wish.id)) known->problem = text;
    if (why.isEmpty())
      bench_.say(QFileInfo(wish.path).fileName() + ": " + text);
    else
      bench_.complain(text);
    if (wish.id != 0) Q_EMIT changed();
  }
  Q_EMIT progress();
  read_next();
}

void Clouds::tell_if_far(const CloudEntry& entry) {
  if (!is_far(entry.id)) return;
  bench_.say(tr("%1 lies %2 from the survey. \"Move here\" in the panel Clouds moves it there.")
                 .arg(entry.name(), distance_words(*distance_m(entry.id))));
}

void Clouds::remove(int id) {
  const auto* gone = find(id);
  if (gone == nullptr) return;
  const auto where = static_cast<std::size_t>(gone - list_.data());
  bench_.session().undo_stack().push(
      new ListCloud(*this, tr("remove cloud %1").arg(gone->name()), false, where, *gone));
}

void Clouds::insert(std::size_t where, CloudEntry entry) {
  if (!entry.read && entry.problem.isEmpty()) wishes_.push_back({entry.id, entry.path});
  drop_distances(entry);  // a survey may have come meanwhile
  list_.insert(list_.begin() + static_cast<std::ptrdiff_t>(std::min(where, list_.size())), std::move(entry));
  update();
  read_next();
}

CloudEntry Clouds::take_out(int id) {
  const auto it = std::ranges::find(list_, id, &CloudEntry::id);
  CloudEntry out = *it;
  list_.erase(it);
  placed_.erase(id);
  forget_distances(id);
  std::erase_if(wishes_, [id](const Wish& wish) { return wish.id == id; });
  update();
  return out;
}

void Clouds::place(int id, const CloudPlacing& at, const QString& what) {
  const auto* before = find(id);
  if (before == nullptr || before->at == at) return;
  bench_.session().undo_stack().push(new PlaceCloud(*this, *before, at, what));
}

void Clouds::put_place(int id, const CloudPlacing& at) {
  auto* placed = entry(id);
  if (placed == nullptr) return;
  placed->at = at;
  drop_distances(*placed);
  forget_distances(id);
  update();
}

// What was measured holds for the places that the clouds had.
void Clouds::drop_distances(CloudEntry& entry) {
  if (!entry.distances) return;
  if (is_of_distances(entry.color_by)) entry.color_by = entry.distances->color_before;
  entry.read = entry.distances->read_before;
  entry.distances.reset();
}

void Clouds::forget_distances(int from) {
  for (auto& entry : list_)
    if (entry.distances && entry.distances->from == from) drop_distances(entry);
}

void Clouds::drop_distances_from(int from) {
  const auto measured = [from](const CloudEntry& entry) { return entry.distances && entry.distances->from == from; };
  if (from == 0 && bench_.scene().survey().points == measured_from_) return;
  if (std::ranges::none_of(list_, measured)) return;
  forget_distances(from);
  update();
}

void Clouds::take_difference(int id, int from, const alignment::DifferenceOptions& options,
                             alignment::CloudDifference difference) {
  auto* measured = entry(id);
  if (measured == nullptr || !measured->read) return;
  drop_distances(*measured);
  auto distances = std::make_shared<CloudDistances>();
  distances->from = from;
  distances->from_name = from == 0 ? tr("the survey") : find(from)->name();
  distances->options = options;
  distances->color_before = measured->color_by;
  distances->read_before = measured->read;
  // What is drawn of a cloud on disk are other points than the coarse ones that were measured.
  if (!measured->read->on_disk()) {
    auto points = *measured->read->points;
    points.set_column(distance_column, std::move(difference.distance_m));
    points.set_column(rise_column, std::move(difference.rise_m));
    auto read = std::make_shared<ReadCloud>(*measured->read);
    read->points = std::make_shared<const PointCloud>(std::move(points));
    measured->read = read;
    measured->color_by = distance_column;
  }
  difference.distance_m.clear();
  difference.rise_m.clear();
  distances->found = std::move(difference);
  const double p95_m = distances->found.p95_m;
  measured->color_range_m = std::max(0.001, std::isfinite(p95_m) ? p95_m : options.max_m);
  measured->distances = distances;
  if (from == 0) measured_from_ = bench_.scene().survey().points;
  update();
}

void Clouds::color_up_to(int id, double metres) {
  auto* painted = entry(id);
  if (painted == nullptr || !(metres > 0)) return;
  painted->color_range_m = metres;
  update();
}

void Clouds::move_here(int id) {
  const auto* moved = find(id);
  if (moved == nullptr || !moved->read) return;
  if (!bench_.scene().has_survey())
    throw bad_input("no survey is shown yet", "one that the cloud can be moved to", "Wait until it is read, or run it");
  const auto move = move_onto(*moved, bench_.scene().whole(), bench_.runner().results());
  const QString name = moved->name();
  place(id, move.to);
  bench_.say((move.by_georeference
                  ? tr("%1 was moved by the place of the survey in their coordinate system: %2, %3, %4 m")
                  : tr("%1 was moved centre onto centre: %2, %3, %4 m"))
                 .arg(name)
                 .arg(move.to.shift_m.x(), 0, 'f', 2)
                 .arg(move.to.shift_m.y(), 0, 'f', 2)
                 .arg(move.to.shift_m.z(), 0, 'f', 2));
}

void Clouds::show(int id, bool on) {
  auto* shown = entry(id);
  if (shown == nullptr || shown->visible == on) return;
  shown->visible = on;
  update();
}

void Clouds::paint(int id, const render::Color& color, const std::string& color_by, double point_px) {
  auto* painted = entry(id);
  if (painted == nullptr) return;
  painted->color = color;
  painted->color_by = color_by;
  painted->point_px = point_px;
  update();
}

void Clouds::fade(int id, double opacity, bool keep) {
  auto* faded = entry(id);
  if (faded == nullptr) return;
  faded->opacity = std::clamp(opacity, min_opacity, 1.0);
  if (keep) return update();
  draw();
  Q_EMIT changed();
}

void Clouds::zoom_to(int id) {
  if (is_drawn(id)) bench_.scene().zoom_to(placed_extent(*find(id)));
}

std::optional<double> Clouds::distance_m(int id) const {
  const auto* asked = find(id);
  if (asked == nullptr || !asked->read || !bench_.scene().has_survey()) return {};
  return gap_m(placed_extent(*asked), bench_.scene().whole());
}

bool Clouds::is_far(int id) const { return distance_m(id).value_or(0) > far_cloud_m; }

bool Clouds::is_drawn(int id) const {
  const auto* asked = find(id);
  return asked != nullptr && asked->visible && asked->read && distance_m(id).value_or(0) <= undrawn_cloud_m;
}

// What turns is computed anew; what is only shifted, or got more columns, shares its points.
const Clouds::Placed& Clouds::placed(const CloudEntry& entry) {
  auto& placed = placed_[entry.id];
  const auto place = entry.place();
  const auto& own = *entry.read->points;
  const bool same_points =
      placed.of && placed.of->points->shared_positions() == own.shared_positions() && lies_alike(placed.place, place);
  if (!same_points) {
    placed = {entry.read, place, std::make_shared<const PointCloud>(placed_cloud(own, place)), entry.read->index};
    if (!place.only_shifts() && !entry.read->on_disk())
      placed.index = std::make_shared<const PointIndex>(placed.points, nullptr, nullptr);
    return placed;
  }
  const Eigen::Vector3d origin = place.of(own.origin);
  if (placed.of == entry.read && placed.points->origin == origin) return placed;
  auto moved = own;
  moved.share_positions(placed.points->shared_positions());
  moved.origin = origin;
  moved.scale = place.moves_nothing() ? own.scale : Eigen::Vector3d::Zero();
  placed.of = entry.read;
  placed.place = place;
  placed.points = std::make_shared<const PointCloud>(std::move(moved));
  return placed;
}

std::shared_ptr<const PointCloud> Clouds::placed_points(int id) {
  const auto* asked = find(id);
  return asked == nullptr || !asked->read ? nullptr : placed(*asked).points;
}

void Clouds::draw() {
  std::vector<SceneCloud> clouds;
  for (const auto& entry : list_) {
    if (!is_drawn(entry.id)) continue;
    const auto& now = placed(entry);
    SceneCloud cloud{entry.id,       entry.name(), now.points,     now.index,    entry.place(),
                     entry.color_by, entry.color,  entry.point_px, entry.opacity};
    if (entry.distances && is_of_distances(entry.color_by)) {
      const double up_to_m = entry.color_range_m;
      cloud.range = render::Interval{entry.color_by == rise_column ? -up_to_m : 0, up_to_m};
      cloud.range_title = entry.color_by == rise_column ? tr("height difference (m)") : tr("distance (m)");
    }
    clouds.push_back(std::move(cloud));
  }
  const auto same = [](const SceneCloud& a, const SceneCloud& b) {
    return a.id == b.id && a.points == b.points && a.index == b.index && a.place == b.place &&
           a.color_by == b.color_by && a.point_px == b.point_px && a.opacity == b.opacity && same_range(a, b) &&
           a.color.r == b.color.r && a.color.g == b.color.g && a.color.b == b.color.b;
  };
  if (!std::ranges::equal(clouds, bench_.scene().clouds(), same)) bench_.scene().set_clouds(std::move(clouds));
  draw_cuts();
}

// The views of one stem; of a cloud on disk they have its coarse points.
void Clouds::draw_cuts() {
  std::vector<CutCloud> cuts;
  if (in_cuts_)
    for (const auto& cloud : bench_.scene().clouds())
      cuts.push_back({cloud.points, cloud.disk() ? nullptr : cloud.index, key_of(cloud).name, cloud.color});
  if (cuts == cuts_) return;
  cuts_ = cuts;
  bench_.slice().show_clouds(cuts);
  bench_.profile().show_clouds(std::move(cuts));
}

void Clouds::show_in_cuts(bool on) {
  in_cuts_ = on;
  QSettings().setValue(in_cuts_key, on);
  draw_cuts();
}

void Clouds::update() {
  draw();
  bench_.guarded([this] { store(); });
  Q_EMIT changed();
  bench_.commands().update();
}

QString Clouds::file() const {
  const QFileInfo document(bench_.session().path());
  return document.dir().filePath(document.completeBaseName() + ".clouds.json");
}

void Clouds::load() {
  dropped_ = true;
  cancel_reading();
  list_.clear();
  placed_.clear();
  unread_.clear();
  QFile stored(file());
  if (stored.open(QIODevice::ReadOnly)) try {
      list_ = parse_clouds(stored.readAll(), QFileInfo(file()).dir());
    } catch (const Error& e) {
      unread_ = file();  // is not written over
      bench_.say(unread_ + ": " + QString::fromUtf8(e.what()));
    }
  for (auto& entry : list_) {
    entry.id = ++last_id_;
    wishes_.push_back({entry.id, entry.path});
  }
  draw();
  Q_EMIT changed();
  if (!list_.empty()) panel_->come_forward();
  read_next();
}

void Clouds::store() const {
  if (bench_.session().path().isEmpty()) return;
  if (file() == unread_)
    throw bad_input("the list of clouds is not kept: " + unread_.toStdString() + " could not be read",
                    "a list of clouds, or none", "Move it away");
  if (list_.empty())
    QFile::remove(file());
  else
    write_text_file(file().toStdString(), clouds_json(list_, QFileInfo(file()).dir()).toStdString());
}

void install_clouds(Workbench& bench) { new Clouds(bench); }

}  // namespace bole::desktop
