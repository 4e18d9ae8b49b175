#include "features/georeference/place_form.h"

#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>

#include "base/atomic_file.h"
#include "cloud/table_columns.h"
#include "document/stage_roles.h"
#include "features/georeference/control_table.h"
#include "io/core/tables/table_file.h"
#include "look/finding_words.h"
#include "look/last_folder.h"
#include "panels/pipeline_panel.h"
#include "views/scene_view.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

constexpr const char *control_port = "control", *targets_port = "targets";
constexpr const char *control_file_option = "file", *system_option = "crs";
constexpr int place_section = 1;  // of the menu Tools
const std::string control_layer = "control";
constexpr const char* dock_id = "place";

std::shared_ptr<const Table> table_in(const Results& results, const std::string& stage, const std::string& port) {
  const auto found = results.find(stage);
  if (found == results.end() || !found->second.has(port)) return nullptr;
  const auto* table = std::get_if<std::shared_ptr<const Table>>(&found->second.all().find(port)->second);
  return table == nullptr ? nullptr : *table;
}

}  // namespace

PlaceForm::PlaceForm(Workbench& bench)
    : QWidget(&bench),
      bench_(bench),
      table_(new ControlTable(this)),
      system_(new QLineEdit(this)),
      said_(new QLabel(this)),
      apply_(new QPushButton(this)) {
  make_widgets();
  auto* dock = bench_.docks().add(dock_id, tr("Place on the earth"), this, Qt::BottomDockWidgetArea, "stems");
  dock->hide();
  make_commands();
  connect(dock, &QDockWidget::visibilityChanged, this, &PlaceForm::draw);
  connect(&bench_, &Workbench::document_opened, this, [this] {
    residuals_.reset();
    table_->setRowCount(0);
    file_.clear();
    say({});
    show_document();
  });
  connect(&bench_.session(), &Session::document_replaced, this, &PlaceForm::show_document);
  connect(&bench_.session(), &Session::option_changed, this, &PlaceForm::show_document);
  connect(&bench_.runner(), &Runner::finished, this, &PlaceForm::take);
}

QString PlaceForm::said() const { return said_->text(); }

void PlaceForm::say(const QString& text) {
  said_->setText(text);
  said_->setVisible(!text.isEmpty());
}

void PlaceForm::make_widgets() {
  system_->setObjectName("control_system");
  system_->setPlaceholderText("EPSG:25832");
  system_->setToolTip(tr("Projected coordinate system of the points and of all exports: an EPSG code or WKT"));
  system_->setMaximumWidth(18 * system_->fontMetrics().averageCharWidth());
  said_->setObjectName("control_said");
  said_->setWordWrap(true);
  said_->hide();  // until there is something to say
  said_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  apply_->setObjectName("control_apply");
  apply_->setText(tr("Give the plot this place"));
  connect(apply_, &QPushButton::clicked, this, [this] { bench_.guarded([&] { apply(); }); });
  auto* line = new QHBoxLayout;
  auto* label = new QLabel(tr("Coordinate system"), this);
  label->setBuddy(system_);
  line->addWidget(label);
  line->addWidget(system_);
  line->addStretch(1);
  line->addWidget(apply_);
  auto* buttons = new QHBoxLayout;
  const auto add = [&](const QString& text, const QString& tip, const std::function<void()>& act) {
    auto* button = new QPushButton(text, this);
    button->setToolTip(tip);
    connect(button, &QPushButton::clicked, this, [this, act] { bench_.guarded(act); });
    buttons->addWidget(button);
  };
  add(tr("Add a point"), tr("Ctrl+V in the table pastes rows of a spreadsheet"), [this] { table_->add_point(); });
  add(tr("Remove"), tr("The selected points"), [this] { table_->remove_points(); });
  add(tr("From a file…"), tr("A table with name, easting_m, northing_m, height_m"), [this] {
    const QString file =
        QFileDialog::getOpenFileName(&bench_, tr("Control points"), last_folder("open"), tr("Tables (*.csv *.txt)"));
    if (!file.isEmpty()) read(note_folder("open", file));
  });
  add(tr("Centre and compass…"), tr("One point and a bearing instead: the options of the stage"),
      [this] { show_stage_options(); });
  buttons->addStretch(1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(2, 2, 2, 2);
  layout->addLayout(line);
  layout->addLayout(buttons);
  layout->addWidget(said_);
  layout->addWidget(table_, 1);
}

void PlaceForm::make_commands() {
  bench_.commands().add(
      {.id = "plot.place",
       .text = tr("Place on the earth…"),
       .places = {in_menu(Menu::tools, place_section)},
       .act = [this] { bench_.docks().raise(dock_id); },
       .enabled_when = {[this] { return stage() != nullptr; }, tr("Open a pipeline with a stage that georeferences.")},
       .tip = tr("Control points, their coordinate system and the residuals")});
}

const pipeline::StageNode* PlaceForm::stage() const {
  if (!bench_.session().has_document()) return nullptr;
  const auto* found = stage_with_output(bench_.session().document(), control_port);
  const bool fits = found != nullptr && found->type->options->find(control_file_option) != nullptr &&
                    found->type->options->find(system_option) != nullptr;
  return fits ? found : nullptr;
}

void PlaceForm::show_document() {
  const auto* node = stage();
  setEnabled(node != nullptr);
  if (node == nullptr) return;
  system_->setText(QString::fromStdString(std::get<std::string>(node->options.get(system_option))));
  const auto file = QString::fromStdString(std::get<std::string>(node->options.get(control_file_option)));
  if (file == file_) return;
  file_ = file;
  table_->setRowCount(0);
  if (file.isEmpty()) return;
  try {
    table_->show_points(io::read_table(file.toStdString()));
  } catch (const Error& e) {
    say(finding_words(QString::fromUtf8(e.what())));
  }
}

void PlaceForm::read(const QString& file) {
  const Table points = io::read_table(file.toStdString());
  for (const char* needed : {"easting_m", "northing_m"})
    if (!points.has(needed))
      throw bad_input(file.toStdString() + " has no column " + needed, "name, easting_m, northing_m, height_m",
                      "Latitudes and longitudes: set the file in the options of the stage");
  table_->show_points(points);
}

void PlaceForm::take(const vtkbridge::RunOutcome& outcome, const Results& results) {
  const auto* node = stage();
  if (node == nullptr || outcome.stages.empty()) return;
  residuals_ = table_in(results, node->id, control_port);
  for (const auto& stage : outcome.stages) {
    if (const auto targets = table_in(results, stage.record.id, targets_port)) table_->show_targets(*targets);
    if (stage.record.id != node->id) continue;
    QStringList lines{finding_words(stage.error.empty() ? stage.record.report.message : stage.error)};
    for (const auto& warning : stage.record.report.warnings) lines << finding_words(warning);
    say(lines.join('\n'));
  }
  table_->show_residuals(residuals_.get());
  table_->resizeColumnsToContents();
  draw();
}

// A name that no file has yet, unless one has this content.
QString PlaceForm::new_file(const std::string& content) const {
  const QFileInfo document(bench_.session().path());
  for (int n = 1;; ++n) {
    const QString name =
        document.completeBaseName() + (n == 1 ? QString("_control.csv") : QString("_control_%1.csv").arg(n));
    QString path = document.dir().filePath(name);
    QFile file(path);
    if (!file.exists() || (file.open(QIODevice::ReadOnly) && file.readAll() == QByteArray::fromStdString(content)))
      return path;
  }
}

void PlaceForm::apply() {
  const auto* node = stage();
  if (node == nullptr)
    throw bad_input("the pipeline has no stage that georeferences", "one like that of the pipeline forest_plot",
                    "Add it behind the stems");
  if (table_->points_given() == 0)
    throw bad_input("no point has easting and northing", "one or more", "Type or paste coordinates into the table");
  const auto content = table_->csv();
  const QString path = new_file(content);
  write_text_file(path.toStdString(), content);
  auto after = bench_.session().document();
  for (auto& other : after.stages()) {
    if (other.id != node->id) continue;
    other.options.set(control_file_option, path.toStdString());
    other.options.set(system_option, system_->text().trimmed().toStdString());
    for (const char* option : {control_file_option, system_option}) other.given.insert(option);
  }
  file_ = path;
  bench_.session().change(tr("Place on the earth"), std::move(after));
  bench_.refresh();
}

void PlaceForm::show_stage_options() {
  if (const auto* node = stage()) {
    bench_.pipeline().select_stage(QString::fromStdString(node->id));
    bench_.docks().raise("options");
  }
}

// Only while the form is seen.
void PlaceForm::draw() {
  std::vector<SceneDrawing> drawings;
  const bool places = residuals_ && residuals_->has("name") && residuals_->has("x_m");
  for (std::size_t i = 0; places && table_->isVisible() && i < residuals_->rows(); ++i) {
    const double z = numbers_or_nan(*residuals_, "z_m")[i];
    const Eigen::Vector3d at(residuals_->numbers("x_m")[i], residuals_->numbers("y_m")[i], std::isfinite(z) ? z : 0);
    if (!at.allFinite()) continue;
    SceneDrawing d;
    d.id = residuals_->text("name", i);
    d.marks = {at};
    d.label = d.id;
    d.label_at = at;
    drawings.push_back(std::move(d));
  }
  bench_.scene().set_drawings(control_layer, std::move(drawings));
}

void install_georeference(Workbench& bench) { new PlaceForm(bench); }

}  // namespace bole::desktop
