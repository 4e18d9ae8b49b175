#include "features/rows/row_editor.h"

#include <fmt/format.h>

#include <QDockWidget>
#include <QHeaderView>
#include <QInputDialog>
#include <QTableView>
#include <QVariant>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "document/edit_list.h"
#include "panels/table_model.h"
#include "views/scene_view.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

using rows::RowEdit;

const std::string rows_layer = "rows";
constexpr double ground_reach_m = 1.0, tick_m = 0.15, plant_m = 0.06, above_ground_m = 0.05;
constexpr std::size_t max_ground_samples = 40'000;
constexpr double min_row_m = 0.1;

std::vector<std::vector<Eigen::Vector3d>> cross_at(const Eigen::Vector3d& at) {
  const Eigen::Vector3d a(tick_m, tick_m, 0), b(tick_m, -tick_m, 0);
  return {{at - a, at + a}, {at - b, at + b}};
}

// Closed: a square for a gap, six corners for a plant.
std::vector<Eigen::Vector3d> outline_at(const Eigen::Vector3d& at, int corners, double radius_m) {
  std::vector<Eigen::Vector3d> line;
  for (int k = 0; k <= corners; ++k) {
    const double angle = 2 * std::numbers::pi * (k + 0.5) / corners;
    line.emplace_back(at + radius_m * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0));
  }
  return line;
}

bool is_gap(const Table& plants, std::size_t row) {
  return plants.has("state") && plants.text("state", row) == "missing";
}

}  // namespace

RowEditor::RowEditor(Workbench& bench) : QObject(&bench), bench_(bench) {
  make_dock();
  make_commands();
  auto& scene = bench_.scene();
  connect(&bench_, &Workbench::document_opened, this, [this] { raised_ = false; });
  connect(&bench_, &Workbench::survey_shown, this, &RowEditor::show_survey);
  connect(&bench_.selection(), &Selection::row_changed, this, &RowEditor::follow_selection);
  connect(&scene, &SceneView::drawing_clicked, this, [this](const QString& which, int drawing) {
    if (which.toStdString() == rows_layer) click_row(drawing);
  });
  connect(&scene, &SceneView::grip_dragged, this,
          [this](const QString& which, int drawing, int grip, const Eigen::Vector3d& at, bool released) {
            if (which.toStdString() == rows_layer) bench_.guarded([&] { drag(drawing, grip, at, released); });
          });
  connect(&scene, &SceneView::place_taken, this, [this](const Eigen::Vector3d& place) {
    if (task_) bench_.guarded([&] { take(place); });
  });
  connect(&scene, &SceneView::place_taker_changed, this, [this](const QObject* taker) {
    if (taker == this) return;
    task_.reset();
    clicked_.clear();
    draw();
  });
}

void RowEditor::make_dock() {
  model_ = new TableModel(this);
  view_ = new QTableView(&bench_);
  view_->setObjectName("row_table");
  view_->setModel(model_);
  view_->setSelectionBehavior(QAbstractItemView::SelectRows);
  view_->setSelectionMode(QAbstractItemView::SingleSelection);
  view_->setAlternatingRowColors(true);
  view_->verticalHeader()->hide();
  view_->verticalHeader()->setDefaultSectionSize(view_->fontMetrics().height() + 6);
  bench_.docks().add("rows", tr("Rows"), view_, Qt::BottomDockWidgetArea, "stems");
  bench_.docks().find("rows")->hide();  // until there are rows
  connect(view_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& current) {
    if (!following_ && current.isValid())
      bench_.selection().select_row(rows_[static_cast<std::size_t>(current.row())].id);
  });
}

void RowEditor::make_commands() {
  const When selected = bench_.with_row();
  bench_.commands().add_submenu({.id = "row.menu", .title = tr("Rows"), .place = in_menu(Menu::tools, 1)});
  const auto add = [&](const char* id, const QString& text, const char* key, const When& when,
                       const std::function<void()>& act) {
    bench_.commands().add({.id = id,
                           .text = text,
                           .key = QKeySequence(key),
                           .places = {in_submenu("row.menu"), in_context("row")},
                           .act = act,
                           .enabled_when = when});
  };
  add("row.add", tr("Add a row by two clicks"), "L", bench_.with_document(), [this] { start(Task::add); });
  add("row.delete", tr("Delete the selected row"), "Ctrl+Delete", selected, [this] { remove(); });
  add("row.split", tr("Split the selected row at a click"), "Shift+S", selected, [this] { start(Task::split); });
  add("row.merge", tr("Merge the selected row with another"), "Shift+G", selected, [this] { start(Task::merge); });
  add("row.renumber", tr("Renumber the selected row…"), "Shift+N", selected, [this] {
    const auto row = selected_or_refuse();
    bool given = false;
    const QString id = QInputDialog::getText(&bench_, tr("Renumber"), tr("New id of the row"), QLineEdit::Normal,
                                             QString::fromStdString(row.id), &given);
    if (given) renumber(id.toStdString());
  });
  add("row.note", tr("Note on the selected row…"), "", selected, [this] {
    selected_or_refuse();
    bool given = false;
    const QString text = QInputDialog::getText(&bench_, tr("Note"), tr("Note"), QLineEdit::Normal, {}, &given);
    if (given) note(text.toStdString());
  });
  bench_.commands().give_context_menu(*view_, "row");
}

void RowEditor::apply(const rows::RowEdit& edit) { add_edits(bench_.session(), {edit}); }

void RowEditor::show_survey(const Survey& survey) {
  const bool same_cloud = survey.points == survey_.points;
  survey_ = survey;
  if (!same_cloud) {
    ground_x_.clear();
    ground_y_.clear();
    ground_z_.clear();
    const auto octree = survey.index ? survey.index->octree() : nullptr;
    if (survey.rows && octree && !octree->nodes().empty()) {
      const auto sample = octree->points(octree->nodes().front());
      const std::size_t step = std::max<std::size_t>(1, sample.size() / max_ground_samples);
      for (std::size_t k = 0; k < sample.size(); k += step) {
        const auto p = survey.points->position(sample[k]);
        ground_x_.push_back(p.x());
        ground_y_.push_back(p.y());
        ground_z_.push_back(p.z());
      }
    }
  }
  read_rows(survey);
  following_ = true;
  model_->show(survey.rows);
  following_ = false;
  if (survey.rows && !std::exchange(raised_, true)) bench_.docks().raise("rows");
  if (!survey.rows) bench_.selection().select_row({});
  follow_selection();
}

void RowEditor::read_rows(const Survey& survey) {
  rows_.clear();
  if (!survey.rows) return;
  const auto& t = *survey.rows;
  for (const char* column : {"row_id", "x0_m", "y0_m", "x1_m", "y1_m"})
    if (!t.has(column)) return;
  const auto x0 = t.numbers("x0_m"), y0 = t.numbers("y0_m"), x1 = t.numbers("x1_m"), y1 = t.numbers("y1_m");
  const auto angle = t.has("angle_deg") ? t.numbers("angle_deg") : std::vector<double>(t.rows(), 0);
  std::map<std::string, std::vector<Eigen::Vector2d>> courses;
  if (survey.lines && survey.lines->has("row_id")) {
    const auto x = survey.lines->numbers("x_m"), y = survey.lines->numbers("y_m");
    for (std::size_t i = 0; i < x.size(); ++i) courses[survey.lines->text("row_id", i)].emplace_back(x[i], y[i]);
  }
  for (std::size_t i = 0; i < t.rows(); ++i) {
    Row row{t.text("row_id", i), {}, {x0[i], y0[i]}, {x1[i], y1[i]}, angle[i]};
    if (const auto it = courses.find(row.id); it != courses.end() && it->second.size() > 1) row.course = it->second;
    if (row.course.empty()) row.course = {row.from, row.to};
    rows_.push_back(std::move(row));
  }
}

// The lowest of the sampled points around, but for strays below the ground.
double RowEditor::ground_z(const Eigen::Vector2d& at) const {
  std::vector<double> near;
  for (std::size_t i = 0; i < ground_x_.size(); ++i)
    if (std::abs(ground_x_[i] - at.x()) < ground_reach_m && std::abs(ground_y_[i] - at.y()) < ground_reach_m)
      near.push_back(ground_z_[i]);
  if (near.empty()) return ground_z_.empty() ? 0 : bench_.scene().whole().lo.z();
  std::ranges::nth_element(near, near.begin() + static_cast<std::ptrdiff_t>(near.size() / 20));
  return near[near.size() / 20];
}

Eigen::Vector3d RowEditor::on_ground(const Eigen::Vector2d& at) const {
  return {at.x(), at.y(), ground_z(at) + above_ground_m};
}

SceneDrawing RowEditor::drawing_of(const Row& row) const {
  SceneDrawing d;
  d.id = row.id;
  d.lines.emplace_back();
  for (const auto& p : row.course) d.lines.back().push_back(on_ground(p));
  d.grips = {on_ground(row.from), on_ground(row.to)};
  d.label = "row " + row.id;
  d.label_at = d.grips[0];
  d.strong = bench_.selection().row() == row.id;
  return d;
}

void RowEditor::draw() {
  std::vector<SceneDrawing> drawings;
  for (const auto& row : rows_) drawings.push_back(drawing_of(row));
  draw_plants(drawings);
  if (clicked_.size() == 1) {
    SceneDrawing begin;
    begin.marks = {on_ground(clicked_[0])};
    drawings.push_back(std::move(begin));
  }
  bench_.scene().set_drawings(rows_layer, std::move(drawings));
}

// Plants, gaps of rows (squares) and plants in no row (crosses), after the rows: clicks count drawings.
void RowEditor::draw_plants(std::vector<SceneDrawing>& drawings) const {
  SceneDrawing plants, doubtful;
  doubtful.warning = true;
  const auto each = [&](const std::shared_ptr<const Table>& table, const auto& act) {
    if (!survey_.rows || !table || !table->has("x_m") || !table->has("y_m")) return;
    const auto x = table->numbers("x_m"), y = table->numbers("y_m");
    for (std::size_t i = 0; i < x.size(); ++i) act(i, on_ground({x[i], y[i]}));
  };
  each(survey_.plants, [&](std::size_t i, const Eigen::Vector3d& at) {
    if (is_gap(*survey_.plants, i))
      doubtful.lines.push_back(outline_at(at, 4, tick_m));
    else
      plants.lines.push_back(outline_at(at, 6, plant_m));
  });
  each(survey_.strays, [&](std::size_t, const Eigen::Vector3d& at) {
    for (auto& line : cross_at(at)) doubtful.lines.push_back(std::move(line));
  });
  for (auto* all : {&plants, &doubtful})
    if (!all->lines.empty()) drawings.push_back(std::move(*all));
}

const RowEditor::Row* RowEditor::selected() const {
  const auto it = std::ranges::find_if(rows_, [this](const Row& row) { return bench_.selection().row() == row.id; });
  return it == rows_.end() ? nullptr : &*it;
}

const RowEditor::Row& RowEditor::selected_or_refuse() const {
  if (const auto* row = selected()) return *row;
  throw bad_input("no row is selected", "a row", "Click it in the view or in the table");
}

rows::RowEdit RowEditor::edit_of(const Row& row, RowEdit::Action action) const {
  rows::RowEdit edit;
  edit.action = action;
  edit.at = row.course.size() > 2 ? row.course[row.course.size() / 2] : Eigen::Vector2d((row.from + row.to) / 2);
  if (std::isfinite(row.angle_deg)) edit.was_angle_deg = row.angle_deg;
  return edit;
}

void RowEditor::drag(int which, int end, const Eigen::Vector3d& at, bool released) {
  if (which < 0 || static_cast<std::size_t>(which) >= rows_.size()) return;
  const auto& row = rows_[static_cast<std::size_t>(which)];
  auto moved = row;
  (end == 0 ? moved.from : moved.to) = at.head<2>();
  const bool changed = (moved.from - row.from).norm() + (moved.to - row.to).norm() > 1e-3;
  if (released && !changed) return draw();
  if (released) {
    auto edit = edit_of(row, RowEdit::Action::move);
    edit.from = moved.from;
    edit.to = moved.to;
    draw();
    return apply(edit);
  }
  moved.course = {moved.from, moved.to};
  std::vector<SceneDrawing> drawings;
  for (const auto& other : rows_) drawings.push_back(drawing_of(other.id == row.id ? moved : other));
  bench_.scene().set_drawings(rows_layer, std::move(drawings));
}

void RowEditor::start(Task task) {
  check_rows_can_be_edited(bench_.session());
  if (task != Task::add) selected_or_refuse();
  bench_.scene().set_place_taker(this);
  task_ = task;
  clicked_.clear();
  bench_.hint(task == Task::add     ? tr("Click where the row begins.")
              : task == Task::split ? tr("Click where the row is to be split.")
                                    : tr("Click the other row."));
}

void RowEditor::stop() {
  if (task_) bench_.scene().set_place_taker(nullptr);
}

void RowEditor::take(const Eigen::Vector3d& place) {
  clicked_.push_back(place.head<2>());
  if (*task_ == Task::add && clicked_.size() < 2) {
    bench_.hint(tr("Click where the row ends."));
    return draw();
  }
  rows::RowEdit edit;
  if (*task_ == Task::add) {
    edit.action = RowEdit::Action::add;
    edit.from = clicked_[0];
    edit.to = clicked_[1];
    if ((*edit.from - *edit.to).norm() < min_row_m) {
      clicked_.pop_back();
      throw bad_input("both ends are at one place", "two ends that are apart", "Click further along the row");
    }
  } else {
    const auto& row = selected_or_refuse();
    edit = edit_of(row, *task_ == Task::split ? RowEdit::Action::split : RowEdit::Action::merge);
    if (*task_ == Task::split)
      edit.at = clicked_[0];
    else
      edit.with = {clicked_[0]};
  }
  stop();
  apply(edit);
}

void RowEditor::click_row(int which) {
  if (static_cast<std::size_t>(which) < rows_.size())
    bench_.selection().select_row(rows_[static_cast<std::size_t>(which)].id);
}

void RowEditor::remove() { apply(edit_of(selected_or_refuse(), RowEdit::Action::remove)); }

void RowEditor::renumber(const std::string& to) {
  auto edit = edit_of(selected_or_refuse(), RowEdit::Action::renumber);
  edit.row_id = to;
  edit.was_angle_deg.reset();
  apply(edit);
}

void RowEditor::note(const std::string& text) {
  auto edit = edit_of(selected_or_refuse(), RowEdit::Action::note);
  edit.text = text;
  edit.was_angle_deg.reset();
  apply(edit);
}

void RowEditor::follow_selection() {
  following_ = true;
  const auto* row = selected();
  if (row != nullptr)
    view_->selectRow(static_cast<int>(row - rows_.data()));
  else
    view_->clearSelection();
  following_ = false;
  draw();
}

void install_rows(Workbench& bench) { new RowEditor(bench); }

}  // namespace bole::desktop
