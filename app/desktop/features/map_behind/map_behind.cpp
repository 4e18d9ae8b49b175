#include "features/map_behind/map_behind.h"

#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <utility>

#include "base/atomic_file.h"
#include "io/core/gdal/map_picture.h"
#include "look/last_folder.h"
#include "views/scene_view.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

constexpr int open_section = 0, look_section = 1;  // of the menus File and View

}  // namespace

MapBehind::MapBehind(Workbench& bench) : QObject(&bench), bench_(bench) {
  make_commands();
  connect(&bench_, &Workbench::document_opened, this, &MapBehind::load);
  connect(&bench_, &Workbench::document_saved, this, [this] { bench_.guarded([this] { store(); }); });
  connect(&bench_, &Workbench::survey_shown, this, &MapBehind::lay);
  connect(&bench_, &Workbench::preview_shown, this, &MapBehind::lay);
  connect(&bench_.scene(), &SceneView::index_built, this, &MapBehind::lay);
  connect(&bench_.scene(), &SceneView::settings_changed, this, &MapBehind::follow_look);
  connect(&work_, &BackgroundWork::done, this, &MapBehind::take);
  connect(&work_, &BackgroundWork::cancelled, this, [this] { refuse({}); });
  connect(&work_, &BackgroundWork::failed, this, &MapBehind::refuse);
}

void MapBehind::make_commands() {
  auto& scene = bench_.scene();
  bench_.commands().add({.id = "map.open",
                         .text = tr("Map behind the survey…"),
                         .places = {in_menu(Menu::file, open_section)},
                         .act = [this] { ask_for_file(); },
                         .enabled_when = bench_.with_document(),
                         .tip = tr("A picture of the place, such as an orthophoto, below the survey")});
  bench_.commands().add({.id = "map.show",
                         .text = tr("Map behind the survey"),
                         .places = {in_menu(Menu::view, look_section)},
                         .turn = [this](bool on) { show(on); },
                         .enabled_when = {[&scene] { return scene.map() != nullptr; },
                                          tr("Open a map first: File > Map behind the survey.")},
                         .checked_when = [&scene] { return scene.map() != nullptr && scene.settings().map; }});
  bench_.commands().add({.id = "map.remove",
                         .text = tr("Remove the map"),
                         .places = {in_menu(Menu::view, look_section)},
                         .act = [this] { remove(); },
                         .enabled_when = {[this] { return !kept_.path.isEmpty(); },
                                          tr("Open a map first: File > Map behind the survey.")}});
}

void MapBehind::ask_for_file() {
  const QString path = QFileDialog::getOpenFileName(
      &bench_, tr("Map behind the survey"), last_folder("map"),
      tr("Pictures with a place on the earth") + " (" + io::map_picture_endings + ");;" + tr("All files") + " (*)");
  if (!path.isEmpty()) open(note_folder("map", path));
}

void MapBehind::open(const QString& path) {
  if (!bench_.session().has_document())
    throw bad_input("nothing is open", "a survey that the map lies behind", "Open a scan or a point cloud first");
  const QString file = QFileInfo(path).absoluteFilePath();
  if (const auto here = ground()) return read(file, *here);
  drop_reading();
  kept_.path = file;
  tried_.reset();
  store();
  show_none();
  if (!bench_.scene().extent_known()) return bench_.say(tr("The map is kept. It is shown with the survey."));
  told_ = true;
  say_no_place();
}

void MapBehind::drop_reading() {
  dropped_ = work_.busy();
  work_.cancel();
  current_.reset();
}

void MapBehind::say_no_place() {
  bench_.complain(
      tr("The survey has no place on the earth yet. The map is kept and is shown once it has one: give it control "
         "points (Tools > Place on the earth)."));
}

void MapBehind::remove() {
  drop_reading();
  kept_.path.clear();
  tried_.reset();
  problem_.clear();
  store();
  show_none();
}

std::optional<MapGround> MapBehind::ground() const {
  if (!bench_.scene().extent_known()) return {};
  const auto frame = place_on_earth(bench_.scene().survey(), bench_.runner().results());
  if (!frame) return {};
  const auto& whole = bench_.scene().whole();
  return report::ground_of(*frame, Eigen::AlignedBox3d(whole.lo, whole.hi));
}

void MapBehind::lay() {
  if (kept_.path.isEmpty() || work_.busy()) return;  // what is busy comes back here
  const auto here = ground();
  if (here) {
    if (!tried_ || !tried_->ground.serves(*here)) read(kept_.path, *here);
    return;
  }
  if (bench_.scene().map()) show_none();
  tried_.reset();
  if (told_ || !bench_.scene().extent_known() || bench_.runner().survey().empty() || bench_.runner().running()) return;
  told_ = true;
  say_no_place();
}

void MapBehind::read(const QString& path, const MapGround& ground) {
  if (work_.busy()) {
    drop_reading();
    current_ = Wish{path, ground};  // begins when the other one has ended
    return;
  }
  dropped_ = false;
  current_ = Wish{path, ground};
  result_.reset();
  work_.start([this, wish = *current_](const Run& run) {
    result_ = std::make_shared<ReadMap>(read_map(wish.path, wish.ground, run));
  });
}

void MapBehind::take() {
  if (dropped_) return refuse({});
  const auto read = std::exchange(result_, nullptr);
  const auto wish = *std::exchange(current_, std::nullopt);
  const bool other = wish.path != kept_.path, again = bench_.scene().map() != nullptr && !other;
  kept_.path = wish.path;
  tried_ = wish;
  problem_.clear();
  bench_.scene().set_map(std::make_shared<const SceneMap>(std::move(read->map)));
  if (other && !bench_.scene().settings().map) show(true);
  if (!again) tell(wish, *read);
  bench_.guarded([this] { store(); });
  bench_.commands().update();
  Q_EMIT changed();
  lay();  // the survey may have grown meanwhile
}

void MapBehind::tell(const Wish& wish, const ReadMap& read) {
  const QString text = tr("%1 lies behind the survey; its pixels are %2 m.")
                           .arg(QFileInfo(wish.path).fileName())
                           .arg(read.file_pixel_m, 0, 'g', 2);
  bench_.say(!read.crs_known
                 ? text + " " + tr("It names no coordinate system and was taken to have that of the survey.")
             : wish.ground.frame.crs_wkt.empty()
                 ? text + " " + tr("The survey names no coordinate system and was taken to have that of the picture.")
                 : text);
}

void MapBehind::show(bool on) {
  auto settings = bench_.scene().settings();
  settings.map = on;
  bench_.scene().set_settings(settings);
  Q_EMIT bench_.scene().settings_changed();
}

void MapBehind::refuse(const QString& why) {
  const auto wish = std::exchange(current_, std::nullopt);
  result_.reset();
  if (std::exchange(dropped_, false)) return wish ? read(wish->path, wish->ground) : lay();
  if (wish && wish->path == kept_.path) {
    tried_ = wish;
    problem_ = why;
    if (bench_.scene().map()) show_none();
  }
  if (!why.isEmpty()) bench_.complain(why);
  Q_EMIT changed();
}

void MapBehind::show_none() {
  bench_.scene().set_map(nullptr);
  bench_.commands().update();
  Q_EMIT changed();
}

void MapBehind::follow_look() {
  const auto& settings = bench_.scene().settings();
  if (kept_.path.isEmpty() || (settings.map == kept_.visible && settings.map_opacity == kept_.opacity &&
                               settings.map_on_terrain == kept_.on_terrain))
    return;
  kept_.visible = settings.map;
  kept_.on_terrain = settings.map_on_terrain;
  kept_.opacity = settings.map_opacity;
  bench_.guarded([this] { store(); });
}

QString MapBehind::file() const {
  const QFileInfo document(bench_.session().path());
  return document.dir().filePath(document.completeBaseName() + ".map.json");
}

void MapBehind::load() {
  drop_reading();
  kept_ = {};
  unread_.clear();
  problem_.clear();
  tried_.reset();
  told_ = false;
  QFile stored(file());
  if (stored.open(QIODevice::ReadOnly)) try {
      kept_ = parse_map(stored.readAll(), QFileInfo(file()).dir());
    } catch (const Error& e) {
      unread_ = file();  // is not written over
      bench_.say(unread_ + ": " + QString::fromUtf8(e.what()));
    }
  auto settings = bench_.scene().settings();
  settings.map = kept_.visible;
  settings.map_opacity = kept_.opacity;
  settings.map_on_terrain = kept_.on_terrain;
  bench_.scene().set_settings(settings);
  show_none();
  lay();
}

void MapBehind::store() {
  if (bench_.session().path().isEmpty()) return;
  if (kept_.path.isEmpty() && (file() == unread_ || !QFile::exists(file()))) return;
  if (file() == unread_)
    throw bad_input("the map is not kept: " + unread_.toStdString() + " could not be read", "a file of a map, or none",
                    "Move it away");
  if (kept_.path.isEmpty())
    QFile::remove(file());
  else
    write_text_file(file().toStdString(), map_json(kept_, QFileInfo(file()).dir()).toStdString());
}

void install_map_behind(Workbench& bench) { new MapBehind(bench); }

}  // namespace bole::desktop
