#include "panels/pipeline_panel.h"

#include <QAction>
#include <QEvent>
#include <QHeaderView>
#include <QInputDialog>
#include <QMenu>
#include <algorithm>
#include <functional>

#include "commands/commands.h"
#include "document/stage_operations.h"
#include "document/stage_words.h"
#include "pipeline/skipped_stages.h"

namespace bole::desktop {
namespace {

QString state_text(StageMark state) {
  switch (state) {
    case StageMark::idle:
      return {};
    case StageMark::running:
      return PipelinePanel::tr("running");
    case StageMark::done:
      return PipelinePanel::tr("done");
    case StageMark::warning:
      return PipelinePanel::tr("warnings");
    case StageMark::failed:
      return PipelinePanel::tr("failed");
  }
  return {};
}

QString id_of(const QTreeWidgetItem* item) { return item->data(0, Qt::UserRole).toString(); }

}  // namespace

PipelinePanel::PipelinePanel(Session& session, Visibility& visibility, Commands& commands, QWidget* parent)
    : QTreeWidget(parent), session_(session), visibility_(visibility) {
  setColumnCount(4);
  setHeaderLabels({tr("Stage"), tr("3-D"), tr("Cut"), tr("State")});
  headerItem()->setToolTip(scene_column, tr("What the 3-D view shows: a click on an eye hides the outputs of a stage"));
  headerItem()->setToolTip(cuts_column, tr("What slice and profile show"));
  setRootIsDecorated(false);
  header()->setMinimumSectionSize(10);
  header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  header()->setSectionResizeMode(stage_column, QHeaderView::Stretch);
  header()->setStretchLastSection(false);
  make_commands(commands);
  connect(&session_, &Session::document_replaced, this, &PipelinePanel::fill);
  connect(&session_, &Session::option_changed, this, &PipelinePanel::show_problems);
  connect(&visibility_, &Visibility::changed, this, [this] {
    for (int i = 0; i < topLevelItemCount(); ++i) show_eyes(topLevelItem(i));
  });
  connect(this, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
    if (item) Q_EMIT stage_selected(id_of(item));
  });
  connect(this, &QTreeWidget::itemClicked, this, &PipelinePanel::click);
}

void PipelinePanel::fill() {
  const QString before = current_stage();
  clear();
  const auto& stages = session_.document().stages();
  for (const auto& node : stages) {
    auto* item = new QTreeWidgetItem(this);
    const bool twin = std::ranges::count(stages, node.type, &pipeline::StageNode::type) > 1;
    const auto title = stage_title(*node.type), id = QString::fromStdString(node.id);
    item->setText(stage_column, twin ? QString("%1 (%2)").arg(title, id) : title);
    item->setData(0, Qt::UserRole, id);
    item->setToolTip(stage_column,
                     id + " (" + QString::fromStdString(node.type->name) + ")\n" + stage_help(*node.type));
    show_eyes(item);
  }
  show_problems();
  select_stage(before);
  if (!currentItem() && topLevelItemCount() > 0) setCurrentItem(topLevelItem(0));
}

void PipelinePanel::show_problems() {
  problems_.clear();
  for (const auto& problem : pipeline::validate(session_.document()))
    problems_[QString::fromStdString(problem.stage)] = QString::fromStdString(problem.message);
  for (int i = 0; i < topLevelItemCount(); ++i) show_state(topLevelItem(i));
}

void PipelinePanel::show_state(QTreeWidgetItem* item) {
  const QString id = id_of(item), problem = problems_.value(id);
  const State state = states_.value(id);
  const bool skipped = pipeline::is_skipped(session_.document(), session_.document().at(id.toStdString()));
  const bool cannot = !problem.isEmpty() && state.state != StageMark::running;
  item->setIcon(state_column, state_icon(cannot ? StageMark::warning : state.state, palette()));
  item->setText(state_column, cannot ? tr("cannot run") : skipped ? tr("skipped") : state_text(state.state));
  item->setToolTip(state_column, cannot    ? problem
                                 : skipped ? tr("This stage runs when its file is given.")
                                           : state.message);
}

void PipelinePanel::show_eyes(QTreeWidgetItem* item) {
  const auto id = id_of(item).toStdString();
  item->setIcon(scene_column, eye_icon(visibility_.shown(id, ViewKind::scene), palette()));
  item->setIcon(cuts_column, eye_icon(visibility_.shown(id, ViewKind::cuts), palette()));
}

void PipelinePanel::click(QTreeWidgetItem* item, int column) {
  if (column != scene_column && column != cuts_column) return;
  const auto view = column == scene_column ? ViewKind::scene : ViewKind::cuts;
  const auto id = id_of(item).toStdString();
  visibility_.show(id, view, !visibility_.shown(id, view));
}

void PipelinePanel::set_state(const QString& stage, StageMark state, const QString& message) {
  states_[stage] = {state, message};
  for (int i = 0; i < topLevelItemCount(); ++i)
    if (id_of(topLevelItem(i)) == stage) show_state(topLevelItem(i));
}

void PipelinePanel::forget_states() {
  states_.clear();
  for (int i = 0; i < topLevelItemCount(); ++i) show_state(topLevelItem(i));
}

QString PipelinePanel::current_stage() const { return currentItem() ? id_of(currentItem()) : QString(); }

void PipelinePanel::select_stage(const QString& id) {
  for (int i = 0; i < topLevelItemCount(); ++i)
    if (id_of(topLevelItem(i)) == id) setCurrentItem(topLevelItem(i));
}

void PipelinePanel::add_stage(const QString& type) {
  auto added = with_stage(session_.document(), pipeline::StageRegistry::global().at(type.toStdString()),
                          current_stage().toStdString());
  session_.change(tr("add %1").arg(QString::fromStdString(added.id)), std::move(added.document));
  select_stage(QString::fromStdString(added.id));
}

void PipelinePanel::delete_stage(const QString& id) {
  session_.change(tr("delete %1").arg(id), without_stage(session_.document(), id.toStdString()));
}

void PipelinePanel::rename_stage(const QString& id, const QString& to) {
  session_.change(tr("rename %1").arg(id), with_stage_renamed(session_.document(), id.toStdString(), to.toStdString()));
  select_stage(to);
}

void PipelinePanel::copy_branch(const QString& id) {
  session_.change(tr("copy %1").arg(id), with_branch_copied(session_.document(), id.toStdString()));
}

void PipelinePanel::make_commands(Commands& commands) {
  commands.add_submenu({.id = "stage.add_menu",
                        .title = tr("Add stage behind"),
                        .place = in_context("pipeline"),
                        .fill = [this](QMenu& menu) { fill_add_menu(menu); }});
  const When has_stage{[this] { return !current_stage().isEmpty(); }, tr("Select a stage first.")};
  const auto add = [&](const char* id, const QString& text, const QKeySequence& key,
                       const std::function<void(const QString& stage)>& act) {
    commands.add({.id = id,
                  .text = text,
                  .key = key,
                  .places = {in_context("pipeline", 1)},
                  .act = [this, act] { act(current_stage()); },
                  .enabled_when = has_stage,
                  .owner = this});
  };
  add("stage.rename", tr("Rename stage…"), Qt::Key_F2, [this](const QString& stage) {
    bool given = false;
    const QString name =
        QInputDialog::getText(this, tr("Rename stage"), tr("Name of the stage"), QLineEdit::Normal, stage, &given);
    if (given) rename_stage(stage, name);
  });
  add("stage.copy_branch", tr("Copy stage and what follows"), QKeySequence("Ctrl+D"),
      [this](const QString& stage) { copy_branch(stage); });
  add("stage.delete", tr("Delete stage"), {}, [this](const QString& stage) { delete_stage(stage); });
  commands.give_context_menu(*this, "pipeline");
  connect(this, &QTreeWidget::currentItemChanged, &commands, &Commands::update);
}

void PipelinePanel::fill_add_menu(QMenu& menu) {
  if (!session_.has_document()) return;
  QMap<QString, QMenu*> groups;
  for (const auto* type : pipeline::StageRegistry::global().all()) {
    const auto name = QString::fromStdString(type->name);
    auto*& group = groups[name.section('.', 0, 0)];
    if (!group) group = menu.addMenu(name.section('.', 0, 0));
    group->setToolTipsVisible(true);
    auto* action = group->addAction(stage_title(*type));
    action->setToolTip(stage_help(*type));
    connect(action, &QAction::triggered, this, [this, name] { guarded([&] { add_stage(name); }); });
  }
}

void PipelinePanel::changeEvent(QEvent* event) {
  QTreeWidget::changeEvent(event);
  if (event->type() != QEvent::PaletteChange || !session_.has_document()) return;
  for (int i = 0; i < topLevelItemCount(); ++i) {
    show_state(topLevelItem(i));
    show_eyes(topLevelItem(i));
  }
}

void PipelinePanel::guarded(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& e) {
    Q_EMIT refused(QString::fromUtf8(e.what()));
  }
}

}  // namespace bole::desktop
