#include "features/loops/loop_editor.h"

#include <QDockWidget>
#include <QHeaderView>
#include <QTableView>
#include <algorithm>

#include "document/edit_list.h"
#include "panels/table_model.h"
#include "views/scene_view.h"
#include "workbench/workbench.h"

namespace bole::desktop {
namespace {

using slam::LoopEdit;

const std::string loops_layer = "loops";
constexpr const char* loops_port = "loop_candidates";

// The table of the last stage that gave one.
std::shared_ptr<const Table> last_loops(const vtkbridge::RunOutcome& outcome, const Results& results) {
  for (auto stage = outcome.stages.rbegin(); stage != outcome.stages.rend(); ++stage) {
    const auto found = results.find(stage->record.id);
    if (found == results.end() || !found->second.has(loops_port)) continue;
    const auto& data = found->second.all().find(loops_port)->second;
    if (const auto* table = std::get_if<std::shared_ptr<const Table>>(&data)) return *table;
  }
  return nullptr;
}

}  // namespace

LoopEditor::LoopEditor(Workbench& bench) : QObject(&bench), bench_(bench) {
  make_dock();
  make_commands();
  connect(&bench_.runner(), &Runner::finished, this, &LoopEditor::take);
  connect(&bench_, &Workbench::survey_shown, this, [this](const Survey& survey) {
    walk_ = survey.walk;
    if (survey.empty()) {
      loops_.reset();
      model_->show(nullptr);
    }
    draw();
  });
  connect(&bench_.scene(), &SceneView::drawing_clicked, this, [this](const QString& layer, int drawing) {
    if (layer.toStdString() == loops_layer && static_cast<std::size_t>(drawing) < drawn_.size())
      select(drawn_[static_cast<std::size_t>(drawing)]);
  });
}

const Table* LoopEditor::loops() const { return loops_.get(); }

void LoopEditor::make_dock() {
  model_ = new TableModel(this);
  view_ = new QTableView(&bench_);
  view_->setObjectName("loop_table");
  view_->setModel(model_);
  view_->setSelectionBehavior(QAbstractItemView::SelectRows);
  view_->setSelectionMode(QAbstractItemView::SingleSelection);
  view_->setAlternatingRowColors(true);
  view_->verticalHeader()->hide();
  view_->verticalHeader()->setDefaultSectionSize(view_->fontMetrics().height() + 6);
  auto* dock = bench_.docks().add("loops", tr("Loop closures"), view_, Qt::BottomDockWidgetArea, "stems");
  dock->hide();
  connect(dock, &QDockWidget::visibilityChanged, this, [this] { draw(); });
  connect(view_->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this] { draw(); });
}

void LoopEditor::make_commands() {
  bench_.commands().add_submenu({.id = "loop.menu", .title = tr("Loop closures"), .place = in_menu(Menu::tools, 1)});
  const auto add = [&](const char* id, const QString& text, const std::function<void()>& act) {
    bench_.commands().add({.id = id,
                           .text = text,
                           .places = {in_submenu("loop.menu"), in_context("loop")},
                           .act = act,
                           .enabled_when = bench_.with_document()});
  };
  add("loop.show", tr("Show the loop closures"), [this] { bench_.docks().raise("loops"); });
  add("loop.accept", tr("Accept the selected loop closure"), [this] { decide(LoopEdit::Action::accept); });
  add("loop.refuse", tr("Strike the selected loop closure out"), [this] { decide(LoopEdit::Action::refuse); });
  bench_.commands().give_context_menu(*view_, "loop");
}

void LoopEditor::take(const vtkbridge::RunOutcome& outcome, const Results& results) {
  const int before = selected();
  loops_ = last_loops(outcome, results);
  model_->show(loops_);
  if (before >= 0) select(before);  // the same candidates come in the same order
  draw();
}

int LoopEditor::selected() const {
  const auto current = view_->selectionModel()->currentIndex();
  return current.isValid() ? current.row() : -1;
}

void LoopEditor::select(int row) {
  if (loops_ && row < static_cast<int>(loops_->rows())) view_->selectRow(row);
}

void LoopEditor::decide(LoopEdit::Action action) {
  const int row = selected();
  if (!loops_ || row < 0 || row >= static_cast<int>(loops_->rows()))
    throw bad_input("no loop closure is selected", "a row of the table", "Click it in the table or in the view");
  LoopEdit edit;
  edit.action = action;
  edit.from_frame = static_cast<std::size_t>(loops_->integers("from_frame")[static_cast<std::size_t>(row)]);
  edit.to_frame = static_cast<std::size_t>(loops_->integers("to_frame")[static_cast<std::size_t>(row)]);
  add_edits(bench_.session(), {edit});
}

// Only while the table is seen: a map full of lines hides its trees.
void LoopEditor::draw() {
  std::vector<SceneDrawing> drawings;
  drawn_.clear();
  if (loops_ && walk_ && view_->isVisible() && loops_->has("from_time_s") && loops_->has("verdict")) {
    const auto from = loops_->numbers("from_time_s"), to = loops_->numbers("to_time_s");
    const auto& verdict = loops_->texts("verdict");
    for (std::size_t i = 0; i < from.size(); ++i) try {
        SceneDrawing d;
        d.id = std::to_string(i);
        d.lines = {{walk_->at(from[i]).translation(), walk_->at(to[i]).translation()}};
        d.strong = selected() == static_cast<int>(i);
        d.warning = verdict[i] != "accepted";
        if (d.strong) {
          d.label = verdict[i];
          d.label_at = d.lines.front().back();
        }
        drawings.push_back(std::move(d));
        drawn_.push_back(static_cast<int>(i));
      } catch (const Error&) {  // a keyframe in a gap of the path
      }
  }
  bench_.scene().set_drawings(loops_layer, std::move(drawings));
}

void install_loops(Workbench& bench) { new LoopEditor(bench); }

}  // namespace bole::desktop
