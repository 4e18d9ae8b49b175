#include "panels/pipeline_panel.h"

#include <QAction>
#include <QEvent>
#include <QHeaderView>
#include <QInputDialog>
#include <QMenu>
#include <functional>

#include "commands/commands.h"
#include "document/stage_operations.h"
#include "document/stage_words.h"
#include "look/stage_icons.h"
#include "running/stage_states.h"

namespace bole::desktop {
namespace {

QString id_of(const QTreeWidgetItem* item) { return item->data(0, Qt::UserRole).toString(); }

}  // namespace

PipelinePanel::PipelinePanel(Session& session, Visibility& visibility, const StageStates& states, Commands& commands,
                             QWidget* parent)
    : QTreeWidget(parent), session_(session), visibility_(visibility), states_(states) {
  setColumnCount(4);
  setHeaderLabels({tr("Stage"), tr("3-D"), tr("Cut"), tr("State")});
  headerItem()->setToolTip(scene_column, tr("What the 3-D view shows: a click on an eye hides the outputs of a stage"));
  headerItem()->setToolTip(cuts_column, tr("What slice and profile show"));
  setRootIsDecorated(false);
  header()->setMinimumSectionSize(10);
  setUniformRowHeights(true);
  header()->setStretchLastSection(false);
  header()->setSectionResizeMode(stage_column, QHeaderView::Stretch);
  fit_columns(true);
  make_commands(commands);
  connect(&session_, &Session::document_replaced, this, &PipelinePanel::fill);
  connect(&states_, &StageStates::changed, this, &PipelinePanel::show_states);
  connect(&states_, &StageStates::stage_changed, this, [this](const QString& id) {
    for (int i = 0; i < topLevelItemCount(); ++i)
      if (id_of(topLevelItem(i)) == id) show_state(topLevelItem(i));
  });
  connect(&visibility_, &Visibility::changed, this,
          [this] { for_all([this](QTreeWidgetItem* item) { show_eyes(item); }); });
  connect(this, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* item) {
    if (item) Q_EMIT stage_selected(id_of(item));
  });
  connect(this, &QTreeWidget::itemClicked, this, &PipelinePanel::click);
}

void PipelinePanel::fit_columns(bool on) {
  for (const int column : {scene_column, cuts_column, state_column})
    header()->setSectionResizeMode(column, on ? QHeaderView::ResizeToContents : QHeaderView::Fixed);
}

// Columns are measured once, not with each cell that changes.
void PipelinePanel::for_all(const std::function<void(QTreeWidgetItem*)>& change) {
  fit_columns(false);
  for (int i = 0; i < topLevelItemCount(); ++i) change(topLevelItem(i));
  fit_columns(true);
}

void PipelinePanel::fill() {
  const QString before = current_stage();
  fit_columns(false);
  clear();
  for (const auto& node : session_.document().stages()) {
    auto* item = new QTreeWidgetItem(this);
    item->setText(stage_column, stage_title(session_.document(), node));
    item->setData(0, Qt::UserRole, QString::fromStdString(node.id));
    item->setToolTip(stage_column, stage_description(node));
  }
  for_all([this](QTreeWidgetItem* item) {
    show_eyes(item);
    show_state(item);
  });
  select_stage(before);
  if (!currentItem() && topLevelItemCount() > 0) setCurrentItem(topLevelItem(0));
}

void PipelinePanel::show_states() {
  for_all([this](QTreeWidgetItem* item) { show_state(item); });
}

void PipelinePanel::show_state(QTreeWidgetItem* item) {
  const auto state = states_.of(id_of(item).toStdString());
  item->setIcon(state_column, state_icon(mark_of(state.kind), palette()));
  item->setText(state_column, state_words(state));
  item->setToolTip(state_column, state_details(state));
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
  for_all([this](QTreeWidgetItem* item) {
    show_state(item);
    show_eyes(item);
  });
}

void PipelinePanel::guarded(const std::function<void()>& act) {
  try {
    act();
  } catch (const Error& e) {
    Q_EMIT refused(QString::fromUtf8(e.what()));
  }
}

}  // namespace bole::desktop
