#include "features/flythrough/flythrough.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QVBoxLayout>
#include <QVariant>

#include "look/finding_words.h"
#include "look/last_folder.h"
#include "report/flight/video.h"
#include "views/scene_view.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

constexpr int film_section = 2, film_steps = 1000;  // of the menu File
constexpr QSize film_sizes[] = {{1280, 720}, {1920, 1080}, {2560, 1440}, {3840, 2160}};

// As the 3-D view, as far as the stage knows its colours.
render::PointColor film_color_of(const std::string& array) {
  if (array == "intensity") return render::PointColor::intensity;
  if (array == "tree_id") return render::PointColor::tree;
  return render::PointColor::height;
}

std::vector<render::ViewPoint> bookmarks_beside(const QString& document) {
  const QFileInfo info(document);
  QFile file(info.dir().filePath(info.completeBaseName() + ".views.json"));
  std::vector<render::ViewPoint> stops;
  if (file.open(QIODevice::ReadOnly))
    for (const auto& named : render::parse_views(file.readAll().toStdString())) stops.push_back(named.view);
  return stops;
}

bool has_walk(const Survey& survey) { return survey.walk && survey.walk->poses.size() > 1; }

}  // namespace

FilmScenery scenery_of(const SceneView& scene) {
  return {scene.clouds(), scene.paint(), scene.map_shown(), scene.terrain_layer().shown()};
}

FlythroughDialog::FlythroughDialog(const Survey& survey, std::vector<render::ViewPoint> stops,
                                   report::FlythroughOptions options, QWidget* parent, FilmScenery scenery)
    : QDialog(parent),
      survey_(survey),
      stops_(std::move(stops)),
      scenery_(std::move(scenery)),
      options_(std::move(options)) {
  setWindowTitle(tr("Flythrough"));
  setObjectName("flythrough_dialog");
  make_form();
  if (!has_walk(survey_)) options_.course = report::FlightCourse::views;
  set_options(options_);
}

FlythroughDialog::~FlythroughDialog() {
  if (!worker_.joinable()) return;
  worker_.request_stop();
  worker_.join();
}

void FlythroughDialog::make_form() {
  course_ = new QComboBox;
  course_->setObjectName("flythrough_course");
  course_->addItem(tr("Along the walk"), static_cast<int>(report::FlightCourse::walk));
  course_->addItem(tr("Through the %1 bookmarked views").arg(stops_.size()),
                   static_cast<int>(report::FlightCourse::views));
  seconds_ = new QDoubleSpinBox;
  seconds_->setRange(0.1, 3600);
  seconds_->setSuffix(tr(" s"));
  rate_ = new QSpinBox;
  rate_->setRange(1, 120);
  rate_->setSuffix(tr(" frames per second"));
  size_ = new QComboBox;
  for (const auto& size : film_sizes) size_->addItem(QString("%1 × %2").arg(size.width()).arg(size.height()), size);
  stems_ = new QCheckBox(tr("Fitted stems"));
  stems_->setEnabled(survey_.stems != nullptr);
  beside_ = new QCheckBox(tr("Clouds beside the survey"));
  beside_->setObjectName("flythrough_clouds");
  beside_->setEnabled(!scenery_.clouds.empty());
  beside_->setChecked(beside_->isEnabled());
  beside_->setToolTip(beside_->isEnabled() ? tr("As the 3-D view shows them: place, colours, opacity, size of points")
                                           : tr("The 3-D view shows no cloud beside the survey."));
  map_ = new QCheckBox(tr("Map behind the survey"));
  map_->setObjectName("flythrough_map");
  map_->setEnabled(scenery_.map.has_value());
  map_->setChecked(map_->isEnabled());
  map_->setToolTip(map_->isEnabled() ? tr("As the 3-D view shows it: flat or on the terrain, and its opacity")
                                     : tr("The 3-D view shows no map behind the survey."));
  terrain_ = new QCheckBox(tr("Terrain with contour lines"));
  terrain_->setObjectName("flythrough_terrain");
  terrain_->setEnabled(scenery_.terrain.has_value());
  terrain_->setChecked(terrain_->isEnabled());
  terrain_->setToolTip(terrain_->isEnabled()
                           ? tr("As the 3-D view shows it: over a map that follows it the contour lines alone")
                           : tr("The 3-D view shows no terrain."));
  video_ = new QCheckBox(tr("Video (MP4)"));
  const bool has_ffmpeg = !report::program_in_path("ffmpeg").empty();
  video_->setEnabled(has_ffmpeg);
  if (!has_ffmpeg) video_->setToolTip(tr("The program ffmpeg is not installed: frames are written as PNG files."));
  what_ = new QLabel;
  what_->setWordWrap(true);
  with_clouds_ = new QLabel;
  with_clouds_->setObjectName("flythrough_clouds_said");
  with_clouds_->setWordWrap(true);
  progress_ = new QProgressBar;
  progress_->setRange(0, film_steps);
  progress_->setVisible(false);
  auto* form = new QFormLayout;
  form->addRow(tr("Course"), course_);
  form->addRow(tr("Length"), seconds_);
  form->addRow(tr("Rate"), rate_);
  form->addRow(tr("Size of a frame"), size_);
  form->addRow(stems_);
  form->addRow(beside_);
  form->addRow(map_);
  form->addRow(terrain_);
  form->addRow(video_);
  auto* buttons = new QDialogButtonBox;
  start_ = buttons->addButton(tr("Make the film…"), QDialogButtonBox::ActionRole);
  cancel_ = buttons->addButton(QDialogButtonBox::Close);
  auto* column = new QVBoxLayout(this);
  column->addLayout(form);
  column->addWidget(with_clouds_);
  column->addWidget(what_);
  column->addWidget(progress_);
  column->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::rejected, this, &FlythroughDialog::reject);
  connect(start_, &QPushButton::clicked, this, [this] {
    const QString folder =
        note_folder("export", QFileDialog::getExistingDirectory(this, tr("Folder of the film"), last_folder("export")));
    if (!folder.isEmpty()) start(folder);
  });
  for (auto* box : {course_, size_})
    connect(box, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &FlythroughDialog::show_what_it_makes);
  connect(seconds_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &FlythroughDialog::show_what_it_makes);
  connect(beside_, &QCheckBox::toggled, this, &FlythroughDialog::show_what_it_makes);
  connect(rate_, QOverload<int>::of(&QSpinBox::valueChanged), this, &FlythroughDialog::show_what_it_makes);
}

void FlythroughDialog::set_options(const report::FlythroughOptions& options) {
  options_ = options;
  course_->setCurrentIndex(course_->findData(static_cast<int>(options.course)));
  seconds_->setValue(options.seconds);
  rate_->setValue(static_cast<int>(options.frame_rate));
  const QSize size(options.width, options.height);
  if (size_->findData(size) < 0) size_->addItem(QString("%1 × %2").arg(size.width()).arg(size.height()), size);
  size_->setCurrentIndex(size_->findData(size));
  stems_->setChecked(options.stems && stems_->isEnabled());
  video_->setChecked(options.video && video_->isEnabled());
  show_what_it_makes();
}

report::FlythroughOptions FlythroughDialog::options() const {
  auto options = options_;
  options.course = static_cast<report::FlightCourse>(course_->currentData().toInt());
  options.seconds = seconds_->value();
  options.frame_rate = rate_->value();
  options.width = size_->currentData().toSize().width();
  options.height = size_->currentData().toSize().height();
  options.stems = stems_->isChecked();
  options.video = video_->isChecked();
  return options;
}

void FlythroughDialog::show_what_it_makes() {
  const auto now = options();
  const bool along = now.course == report::FlightCourse::walk;
  const QString missing = along && !has_walk(survey_)   ? tr("The survey has no walk.")
                          : !along && stops_.size() < 2 ? tr("Bookmark two views or more (Ctrl+B).")
                                                        : QString();
  with_clouds_->setText(words_of_clouds());
  with_clouds_->setVisible(!with_clouds_->text().isEmpty());
  start_->setEnabled(missing.isEmpty() && !busy_);
  what_->setText(missing.isEmpty() ? tr("%n frame(s) as PNG files", nullptr, static_cast<int>(frames_of(now)))
                                   : missing);
}

render::Surroundings FlythroughDialog::surroundings() const {
  render::Surroundings about;
  if (beside_->isChecked())
    for (const auto& cloud : scenery_.clouds)
      about.clouds.push_back({cloud.points, paint_of(cloud, scenery_.of_survey), cloud.point_px, cloud.opacity});
  if (map_->isChecked()) about.ground = scenery_.map;
  if (terrain_->isChecked()) {
    about.terrain = scenery_.terrain;
    about.terrain->lines_only = about.ground && !about.ground->places.behind_all;
  }
  return about;
}

QString FlythroughDialog::words_of_clouds() const {
  QStringList names;
  bool coarse = survey_.index && survey_.index->disk();
  if (beside_->isChecked())
    for (const auto& cloud : scenery_.clouds) {
      names << cloud.name;
      coarse = coarse || cloud.disk();
    }
  QStringList lines;
  if (!names.isEmpty()) lines << tr("With %1").arg(names.join(", "));
  if (coarse) lines << tr("Of clouds that are shown from the disk the film has the coarse points.");
  return lines.join('\n');
}

void FlythroughDialog::start(const QString& folder) {
  if (busy_) return;
  if (worker_.joinable()) worker_.join();
  busy_ = true;
  start_->setEnabled(false);
  cancel_->setText(tr("Cancel"));
  progress_->setValue(0);
  progress_->setVisible(true);
  worker_ = std::jthread([this, folder, wanted = options(), survey = survey_, stops = stops_,
                          about = surroundings()](const std::stop_token& stop) {
    Run run;
    run.cancel = stop;
    run.progress = [this, last = -1](double fraction, std::string_view what) mutable {
      const int step = static_cast<int>(fraction * film_steps);
      if (step == last) return;
      last = step;
      QMetaObject::invokeMethod(
          this,
          [this, step, text = QString::fromUtf8(what.data(), static_cast<int>(what.size()))] {
            progress_->setValue(step);
            progress_->setToolTip(text);
          },
          Qt::QueuedConnection);
    };
    QString said, why;
    try {
      render::MapData data;
      data.points = survey.points.get();
      data.stems = survey.stems.get();
      data.sections = survey.sections.get();
      data.trajectory = survey.walk.get();
      const auto flight = report::flight_of(wanted, survey.walk.get(), stops);
      const auto report = report::write_flythrough(data, flight, wanted, folder.toStdString(), run, about);
      said = QString::fromStdString(report.message);
    } catch (const std::exception& e) {
      why = QString::fromUtf8(e.what());
    }
    QMetaObject::invokeMethod(
        this, [this, said, why] { end(said, why); }, Qt::QueuedConnection);
  });
}

void FlythroughDialog::end(const QString& said, const QString& why) {
  busy_ = false;
  progress_->setVisible(false);
  cancel_->setText(tr("Close"));
  show_what_it_makes();
  what_->setText(finding_words(why.isEmpty() ? said : why));
  if (why.isEmpty())
    Q_EMIT made(said);
  else
    Q_EMIT refused(why);
}

void FlythroughDialog::cancel() { worker_.request_stop(); }

void FlythroughDialog::reject() {
  if (busy_) return cancel();
  QDialog::reject();
}

void install_flythrough(Workbench& bench) {
  auto* b = &bench;
  bench.commands().add({.id = "view.flythrough",
                        .text = FlythroughDialog::tr("Flythrough…"),
                        .key = QKeySequence("Ctrl+Shift+F"),
                        .places = {in_menu(Menu::file, film_section), in_context("scene", 2)},
                        .act =
                            [b] {
                              report::FlythroughOptions options;
                              options.color = film_color_of(b->scene().settings().color);
                              options.point_size = b->scene().settings().point_size_px;
                              FlythroughDialog dialog(b->scene().survey(), bookmarks_beside(b->session().path()),
                                                      options, b, scenery_of(b->scene()));
                              QObject::connect(&dialog, &FlythroughDialog::made, b,
                                               [b](const QString& said) { b->say(said); });
                              dialog.exec();
                            },
                        .enabled_when = {[b] { return b->scene().survey().points != nullptr; },
                                         FlythroughDialog::tr("Open a scan or a point cloud first.")}});
}

}  // namespace bole::desktop
