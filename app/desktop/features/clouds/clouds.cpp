#include "features/clouds/clouds.h"

#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <algorithm>
#include <cmath>

#include "base/atomic_file.h"
#include "document/disk_memory.h"
#include "document/file_kinds.h"
#include "features/clouds/cloud_distance.h"
#include "features/clouds/cloud_file.h"
#include "features/clouds/cloud_panel.h"
#include "look/last_folder.h"
#include "views/scene_view.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

constexpr int cloud_section = 0;    // of the menu File
constexpr int place_step = 0x0c10;  // of undo, for steps that go on with one another

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
  PlaceCloud(Clouds& clouds, const CloudEntry& before, const Eigen::Vector3d& shift_m, double turn_deg)
      : SignedCommand(Clouds::tr("move cloud %1").arg(before.name())),
        clouds_(clouds),
        cloud_(before.id),
        shift_before_m_(before.shift_m),
        shift_after_m_(shift_m),
        turn_before_deg_(before.turn_deg),
        turn_after_deg_(turn_deg) {}
  void undo() override { clouds_.put_place(cloud_, shift_before_m_, turn_before_deg_); }
  void redo() override { clouds_.put_place(cloud_, shift_after_m_, turn_after_deg_); }

  // Arrows that are held in a box are one step.
  int id() const override { return place_step; }
  bool mergeWith(const QUndoCommand* other) override {
    const auto* next = dynamic_cast<const PlaceCloud*>(other);
    if (next == nullptr || next->cloud_ != cloud_) return false;
    shift_after_m_ = next->shift_after_m_;
    turn_after_deg_ = next->turn_after_deg_;
    return true;
  }

 private:
  Clouds& clouds_;
  int cloud_;
  Eigen::Vector3d shift_before_m_, shift_after_m_;
  double turn_before_deg_, turn_after_deg_;
};

Clouds::Clouds(Workbench& bench) : QObject(&bench), bench_(bench) {
  make_commands();
  panel_ = new CloudPanel(*this, bench);
  connect(&bench_, &Workbench::document_opened, this, &Clouds::load);
  connect(&bench_, &Workbench::document_saved, this, [this] { bench_.guarded([this] { store(); }); });
  connect(&bench_, &Workbench::cloud_dropped, this,
          [this](const QString& path) { bench_.guarded([&] { add(path); }); });
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

void Clouds::make_commands() {
  auto& commands = bench_.commands();
  const auto chosen = [this] { return panel_ == nullptr ? nullptr : find(panel_->current()); };
  const When with_cloud{[chosen] { return chosen() != nullptr; }, tr("Select a cloud in the panel Clouds first.")};
  const When with_read{[chosen] { return chosen() != nullptr && chosen()->read != nullptr; },
                       tr("Select a cloud in the panel Clouds first.")};
  commands.add({.id = "clouds.add",
                .text = tr("Add a cloud to look at…"),
                .key = QKeySequence("Ctrl+Shift+A"),
                .places = {in_menu(Menu::file, cloud_section), in_context("clouds")},
                .act = [this] { ask_for_files(); },
                .enabled_when = bench_.with_document(),
                .tip = tr("Another point cloud beside the survey: drawn, measured and cut, never computed with")});
  commands.add({.id = "clouds.show",
                .text = tr("Show the cloud"),
                .places = {in_context("clouds")},
                .turn = [this](bool on) { show(panel_->current(), on); },
                .enabled_when = with_cloud,
                .checked_when = [chosen] { return chosen() != nullptr && chosen()->visible; }});
  commands.add({.id = "clouds.zoom",
                .text = tr("Zoom to the cloud"),
                .places = {in_context("clouds")},
                .act = [this] { zoom_to(panel_->current()); },
                .enabled_when = {[this, chosen] { return chosen() != nullptr && is_drawn(panel_->current()); },
                                 tr("Select a cloud that is drawn first.")}});
  commands.add({.id = "clouds.move_here",
                .text = tr("Move the cloud to the survey"),
                .places = {in_context("clouds")},
                .act = [this] { move_here(panel_->current()); },
                .enabled_when = with_read,
                .tip = tr("By the coordinate system where both have one, else centre onto centre; its numbers can be "
                          "changed afterwards")});
  commands.add({.id = "clouds.remove",
                .text = tr("Remove the cloud"),
                .places = {in_context("clouds")},
                .act = [this] { remove(panel_->current()); },
                .enabled_when = with_cloud,
                .tip = tr("From the list; its file stays")});
  commands.add({.id = "clouds.cancel",
                .text = tr("Cancel the reading"),
                .places = {in_context("clouds", 1)},
                .act = [this] { cancel_reading(); },
                .enabled_when = {[this] { return reading(); }, tr("No cloud is being read.")}});
}

void Clouds::ask_for_files() {
  const auto paths =
      QFileDialog::getOpenFileNames(&bench_, tr("Add a cloud to look at"), last_folder("open"),
                                    tr("Point clouds") + " (" + cloud_endings() + ");;" + tr("All files") + " (*)");
  for (const auto& path : paths) add(note_folder("open", path));
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
    added.pivot_m = ((read->extent.lo + read->extent.hi) / 2).head<2>().array().round();
    bench_.session().undo_stack().push(
        new ListCloud(*this, tr("add cloud %1").arg(added.name()), true, list_.size(), added));
    panel_->select(added.id);
    tell_if_far(added);
  } else if (auto* known = dropped_ ? nullptr : entry(wish.id)) {
    known->read = read;
    if (!known->pivot_m) known->pivot_m = ((read->extent.lo + read->extent.hi) / 2).head<2>().array().round();
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
  list_.insert(list_.begin() + static_cast<std::ptrdiff_t>(std::min(where, list_.size())), std::move(entry));
  update();
  read_next();
}

CloudEntry Clouds::take_out(int id) {
  const auto it = std::ranges::find(list_, id, &CloudEntry::id);
  CloudEntry out = *it;
  list_.erase(it);
  placed_.erase(id);
  std::erase_if(wishes_, [id](const Wish& wish) { return wish.id == id; });
  update();
  return out;
}

void Clouds::place(int id, const Eigen::Vector3d& shift_m, double turn_deg) {
  const auto* before = find(id);
  if (before == nullptr || (before->shift_m == shift_m && before->turn_deg == turn_deg)) return;
  bench_.session().undo_stack().push(new PlaceCloud(*this, *before, shift_m, turn_deg));
}

void Clouds::put_place(int id, const Eigen::Vector3d& shift_m, double turn_deg) {
  auto* placed = entry(id);
  if (placed == nullptr) return;
  placed->shift_m = shift_m;
  placed->turn_deg = turn_deg;
  update();
}

void Clouds::move_here(int id) {
  const auto* moved = find(id);
  if (moved == nullptr || !moved->read) return;
  if (!bench_.scene().has_survey())
    throw bad_input("no survey is shown yet", "one that the cloud can be moved to", "Wait until it is read, or run it");
  const auto move = move_onto(*moved, bench_.scene().whole(), bench_.runner().results());
  const QString name = moved->name();
  place(id, move.shift_m, move.turn_deg);
  bench_.say((move.by_georeference
                  ? tr("%1 was moved by the place of the survey in their coordinate system: %2, %3, %4 m")
                  : tr("%1 was moved centre onto centre: %2, %3, %4 m"))
                 .arg(name)
                 .arg(move.shift_m.x(), 0, 'f', 2)
                 .arg(move.shift_m.y(), 0, 'f', 2)
                 .arg(move.shift_m.z(), 0, 'f', 2));
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

// What turns is computed anew; what is only shifted shares its points.
void Clouds::draw() {
  std::vector<SceneCloud> clouds;
  for (const auto& entry : list_) {
    if (!is_drawn(entry.id)) continue;
    auto& placed = placed_[entry.id];
    const auto place = entry.place();
    const auto& own = *entry.read->points;
    if (placed.of != entry.read || placed.turn_deg != entry.turn_deg) {
      placed = {entry.read, entry.turn_deg, std::make_shared<const PointCloud>(placed_cloud(own, place)),
                entry.read->index};
      if (entry.turn_deg != 0 && !entry.read->on_disk())
        placed.index = std::make_shared<const PointIndex>(placed.points, nullptr, nullptr);
    } else if (const Eigen::Vector3d origin = place.of(own.origin); placed.points->origin != origin) {
      auto moved = *placed.points;
      moved.origin = origin;
      moved.scale = place.moves_nothing() ? own.scale : Eigen::Vector3d::Zero();
      placed.points = std::make_shared<const PointCloud>(std::move(moved));
    }
    clouds.push_back(
        {entry.id, entry.name(), placed.points, placed.index, place, entry.color_by, entry.color, entry.point_px});
  }
  const auto same = [](const SceneCloud& a, const SceneCloud& b) {
    return a.id == b.id && a.points == b.points && a.index == b.index && a.place == b.place &&
           a.color_by == b.color_by && a.point_px == b.point_px && a.color.r == b.color.r && a.color.g == b.color.g &&
           a.color.b == b.color.b;
  };
  if (!std::ranges::equal(clouds, bench_.scene().clouds(), same)) bench_.scene().set_clouds(std::move(clouds));
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
