#include "features/field_check/field_check.h"

#include <vtkMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

#include <QFileDialog>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QSplitter>
#include <QTableView>
#include <QVBoxLayout>
#include <cmath>

#include "document/edit_list.h"
#include "features/field_check/field_list_dialog.h"
#include "io/core/tables/table_file.h"
#include "look/last_folder.h"
#include "panels/row_filter.h"
#include "panels/table_model.h"
#include "render/scene/actors.h"
#include "views/chart_view.h"
#include "views/scene_view.h"
#include "workbench/workbench.h"

namespace bole::desktop {

FieldCheck::FieldCheck(Workbench& bench)
    : bench_(bench),
      summary_(new QLabel(this)),
      map_(new PlotMap(bench.selection(), this)),
      table_(new QTableView(this)),
      model_(new TableModel(this)),
      filter_(new RowFilter(this)) {
  make_commands();
  make_table();
  auto* split = new QSplitter(Qt::Horizontal, this);
  split->addWidget(map_);
  split->addWidget(table_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(2, 2, 2, 2);
  layout->addWidget(header());
  layout->addWidget(split, 1);
  connect(map_, &PlotMap::chosen, this, &FieldCheck::choose);
  connect(map_, &PlotMap::menu_wanted, this, &FieldCheck::show_menu);
  connect(&bench_, &Workbench::survey_shown, this, &FieldCheck::show_survey);
  connect(&bench_.selection(), &Selection::changed, this, [this] {
    const auto tree = bench_.selection().tree();
    for (std::size_t i = 0; tree && i < rows_.size(); ++i)
      if (rows_[i].tree == tree && !following_) choose(static_cast<int>(i));
  });
  show_summary();
}

void FieldCheck::make_commands() {
  bench_.commands().add(
      {.id = "field.load", .text = tr("Load field measurements…"), .places = {in_menu(Menu::stem, 1)}, .act = [this] {
         const QString file = QFileDialog::getOpenFileName(&bench_, tr("Load field measurements"), last_folder("open"),
                                                           tr("Tables (*.csv *.txt)"));
         if (!file.isEmpty()) load(note_folder("open", file));
       }});
  bench_.commands().add(
      {.id = "field.add_missed",
       .text = tr("Add a stem here, fitted to the points"),
       .places = {in_context("field_missed")},
       .act = [this] { add_missed(current_); },
       .enabled_when = {[this] { return current() != nullptr && current()->kind == MatchKind::missed; },
                        tr("Select a tree that was missed.")}});
}

const MatchRow* FieldCheck::current() const {
  return current_ >= 0 && current_ < static_cast<int>(rows_.size()) ? &rows_[static_cast<std::size_t>(current_)]
                                                                    : nullptr;
}

QWidget* FieldCheck::header() {
  auto* line = new QWidget(this);
  auto* layout = new QHBoxLayout(line);
  layout->setContentsMargins(2, 0, 2, 0);
  auto* load = new QPushButton(tr("Load field measurements…"), line);
  connect(load, &QPushButton::clicked, bench_.commands().action("field.load"), &QAction::trigger);
  summary_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  summary_->setWordWrap(true);
  layout->addWidget(load);
  layout->addWidget(summary_, 1);
  return line;
}

void FieldCheck::make_table() {
  filter_->setSourceModel(model_);
  table_->setModel(filter_);
  table_->setObjectName("matches");
  table_->setSortingEnabled(true);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setAlternatingRowColors(true);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(table_->fontMetrics().height() + 6);
  table_->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this](const QModelIndex& index) {
    if (index.isValid() && !following_) choose(row_of_view(index));
  });
  connect(table_, &QTableView::customContextMenuRequested, this, [this](const QPoint& at) {
    if (const auto index = table_->indexAt(at); index.isValid())
      show_menu(row_of_view(index), table_->viewport()->mapToGlobal(at));
  });
}

int FieldCheck::row_of_view(const QModelIndex& index) const { return filter_->mapToSource(index).row(); }

void FieldCheck::load(const QString& file) {
  if (!bench_.session().has_document()) throw bad_input("no pipeline is open", "one that measures stems");
  const Table list = io::read_table(file.toStdString());
  FieldListDialog dialog(list, file, &bench_);
  if (dialog.exec() == QDialog::Accepted) load(file, dialog.mapping(), dialog.align());
}

void FieldCheck::load(const QString& file, const FieldMapping& mapping, const std::string& align) {
  bench_.session().change(tr("field measurements"),
                          with_field_list(bench_.session().document(), file.toStdString(), mapping, align));
  bench_.docks().raise("field_check");
  bench_.chart().show_chart("field");
  bench_.docks().raise("chart");
  bench_.refresh();
}

void FieldCheck::show_survey(const Survey& survey) {
  survey_ = survey;
  if (survey_.matches && !survey_.matches->has("dbh_cm")) survey_.matches.reset();  // matches of rows of plants
  rows_ = survey_.matches ? match_rows(*survey_.matches) : std::vector<MatchRow>();
  current_ = -1;
  following_ = true;
  filter_->set_table(survey_.matches.get());
  model_->show(survey_.matches);
  table_->resizeColumnsToContents();
  following_ = false;
  map_->show_matches(rows_);
  show_summary();
  draw_rings();
}

void FieldCheck::choose(int row) {
  if (row < 0 || row >= static_cast<int>(rows_.size())) return;
  following_ = true;
  current_ = row;
  map_->set_current(row);
  const auto index = filter_->mapFromSource(model_->index(row, 0));
  table_->selectRow(index.row());
  table_->scrollTo(index);
  if (const auto tree = rows_[static_cast<std::size_t>(row)].tree) bench_.selection().select(tree);
  following_ = false;
  bench_.commands().update();
}

void FieldCheck::show_menu(int row, const QPoint& global) {
  choose(row);
  const bool missed = current() != nullptr && current()->kind == MatchKind::missed;
  bench_.commands().show_menu(missed ? "field_missed" : "stem", global);
}

void FieldCheck::add_missed(int row) {
  const auto& match = rows_.at(static_cast<std::size_t>(row));
  if (match.kind != MatchKind::missed) throw bad_input("the tree was found", "a missed one");
  stems::StemEdit edit;
  edit.action = stems::StemEdit::Action::add;
  edit.at = {match.field_m.x(), match.field_m.y()};
  edit.reason = "in the field list";
  add_edits(bench_.session(), {edit});
}

void FieldCheck::delete_false(int row) {
  const auto& match = rows_.at(static_cast<std::size_t>(row));
  if (match.kind != MatchKind::falsely) throw bad_input("the tree is in the field list", "a false one");
  stems::StemEdit edit;
  edit.action = stems::StemEdit::Action::remove;
  edit.at = {match.stem_m.x(), match.stem_m.y()};
  edit.was_dbh_cm = match.dbh_cm;
  edit.reason = "not in the field list";
  add_edits(bench_.session(), {edit});
}

void FieldCheck::show_summary() {
  int counts[3] = {0, 0, 0};
  double sum = 0, squares = 0;
  int n = 0;
  for (const auto& row : rows_) {
    ++counts[static_cast<int>(row.kind)];
    const double error = row.dbh_cm - row.field_dbh_cm;
    if (row.kind == MatchKind::matched && std::isfinite(error)) {
      sum += error;
      squares += error * error;
      ++n;
    }
  }
  if (rows_.empty()) return summary_->setText(tr("No field measurements yet."));
  QString text = tr("%1 matched, %2 missed, %3 false").arg(counts[0]).arg(counts[1]).arg(counts[2]);
  if (n > 0)
    text += QStringLiteral("; ") + tr("diameters: bias %1 cm, RMSE %2 cm")
                                       .arg(0.01 * std::round(100 * sum / n) + 0.0, 0, 'f', 2)  // never -0.00
                                       .arg(std::sqrt(squares / n), 0, 'f', 2);
  summary_->setText(text);
}

// The view takes all its props away with every survey, so that these are made anew.
void FieldCheck::draw_rings() {
  constexpr double half_height_m = 0.08;
  auto* renderer = bench_.scene().renderWindow()->GetRenderers()->GetFirstRenderer();
  if (!renderer) return;
  for (const auto& ring : rings_) renderer->RemoveActor(ring);
  rings_.clear();
  if (!survey_.stems || rows_.empty()) return;
  const Eigen::Vector3d origin = survey_.points ? survey_.points->origin : Eigen::Vector3d::Zero().eval();
  const auto shapes = render::stem_shapes(*survey_.stems, survey_.sections.get());
  for (const auto kind : {MatchKind::matched, MatchKind::missed, MatchKind::falsely}) {
    std::vector<render::StemShape> marked;
    for (const auto& row : rows_) {
      if (row.kind != kind) continue;
      if (row.tree) {
        for (const auto& shape : shapes)
          if (shape.tree_id == row.tree) marked.push_back(shape);
      } else if (!shapes.empty()) {
        render::StemShape shape = shapes.front();  // upright, at the height of any other
        shape.breast_height.head<2>() = Eigen::Vector2d(row.field_m.x(), row.field_m.y());
        shape.breast_radius_m = 0.005 * row.field_dbh_cm;
        marked.push_back(shape);
      }
    }
    if (marked.empty()) continue;
    auto actor = render::breast_height_actor(marked, origin, half_height_m);
    actor->GetMapper()->ScalarVisibilityOff();
    const QColor color = match_color(kind, palette());
    actor->GetProperty()->SetColor(color.redF(), color.greenF(), color.blueF());
    renderer->AddActor(actor);
    rings_.push_back(actor);
  }
  if (bench_.scene().isValid()) bench_.scene().renderWindow()->Render();
}

void install_field_check(Workbench& bench) {
  auto* check = new FieldCheck(bench);
  check->setObjectName("field_check_panel");
  bench.docks().add("field_check", FieldCheck::tr("Field check"), check, Qt::BottomDockWidgetArea, "stems");
}

}  // namespace bole::desktop
