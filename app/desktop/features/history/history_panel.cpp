#include "features/history/history_panel.h"

#include <QFont>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QSplitter>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "document/session.h"
#include "running/comparison.h"
#include "running/runner.h"

namespace bole::desktop {
namespace {

constexpr int id_role = Qt::UserRole;

QTreeWidget* list(const QStringList& columns, const char* name, QWidget* parent) {
  auto* tree = new QTreeWidget(parent);
  tree->setObjectName(name);
  tree->setHeaderLabels(columns);
  tree->setRootIsDecorated(false);
  tree->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  return tree;
}

}  // namespace

HistoryPanel::HistoryPanel(Session& session, Runner& runs, QWidget* parent)
    : QWidget(parent),
      session_(session),
      runs_(runs),
      edits_(list({tr("Edit"), tr("By"), tr("At")}, "edits", this)),
      list_(list({tr("Run"), tr("At"), tr("Result"), tr("Changed options")}, "runs", this)),
      show_(new QPushButton(tr("Show again"), this)),
      take_(new QPushButton(tr("Take its options"), this)),
      compare_(new QPushButton(tr("Compare two"), this)) {
  list_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  show_->setObjectName("show_run");
  take_->setObjectName("take_options");
  compare_->setObjectName("compare_runs");
  show_->setToolTip(tr("Shows what this run gave, from the cache"));
  take_->setToolTip(tr("Sets the options of the document to those of this run; can be undone"));
  compare_->setToolTip(tr("Opens two chosen runs side by side"));
  auto* buttons = new QHBoxLayout;
  for (auto* b : {show_, take_, compare_}) buttons->addWidget(b);
  auto* runs_box = new QWidget(this);
  auto* runs_layout = new QVBoxLayout(runs_box);
  runs_layout->setContentsMargins(0, 0, 0, 0);
  runs_layout->setSpacing(2);
  runs_layout->addWidget(list_);
  runs_layout->addLayout(buttons);
  auto* splitter = new QSplitter(Qt::Vertical, this);
  splitter->addWidget(runs_box);
  splitter->addWidget(edits_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(splitter);

  connect(&session_.undo_stack(), &QUndoStack::indexChanged, this, &HistoryPanel::fill_edits);
  connect(&session_, &Session::document_replaced, this, &HistoryPanel::fill_edits);
  connect(edits_, &QTreeWidget::itemClicked, this,
          [this](QTreeWidgetItem* item) { session_.undo_stack().setIndex(item->data(0, id_role).toInt()); });
  connect(&runs_, &Runner::job_ended, this, &HistoryPanel::fill_runs);
  connect(list_, &QTreeWidget::itemSelectionChanged, this, &HistoryPanel::enable_buttons);
  connect(list_, &QTreeWidget::itemDoubleClicked, this, &HistoryPanel::show_run);
  connect(show_, &QPushButton::clicked, this, &HistoryPanel::show_run);
  connect(take_, &QPushButton::clicked, this, &HistoryPanel::take_options);
  connect(compare_, &QPushButton::clicked, this, [this] {
    const auto ids = chosen();
    if (ids.size() == 2) Q_EMIT compare_asked(ids[0], ids[1]);
  });
  fill_edits();
  enable_buttons();
}

void HistoryPanel::fill_edits() {
  edits_->clear();
  const auto& stack = session_.undo_stack();
  const auto add = [&](int index, const QStringList& texts) {
    auto* item = new QTreeWidgetItem(edits_, texts);
    item->setData(0, id_role, index);
    QFont font = item->font(0);
    font.setBold(index == stack.index());
    item->setFont(0, font);
    if (index > stack.index())
      for (int c = 0; c < 3; ++c) item->setForeground(c, palette().color(QPalette::Disabled, QPalette::Text));
    if (index == stack.index()) edits_->scrollToItem(item);
  };
  if (!session_.has_document()) return;
  add(0, {tr("As opened"), {}, {}});
  for (int i = 0; i < stack.count(); ++i) {
    const auto note = session_.edit_note(i);
    add(i + 1, {stack.text(i), note.author, note.time.toString("HH:mm:ss")});
  }
}

// Runs that somebody asked for, the newest first; what is run anew after an edit is none of them.
void HistoryPanel::fill_runs() {
  const auto before = chosen();
  list_->clear();
  for (auto job = runs_.jobs().rbegin(); job != runs_.jobs().rend(); ++job) {
    if (!(*job)->asked || !(*job)->over()) continue;
    const auto& j = **job;
    const bool shown = j.has_result();
    auto* item = new QTreeWidgetItem(
        list_, {QString::number(j.id), j.asked_at.toString("HH:mm:ss"),
                shown ? headline(j.outcome) + (j.state == JobState::kept ? tr(" (ended early)") : QString())
                      : job_state_text(j.state),
                j.changes});
    item->setData(0, id_role, j.id);
    item->setSelected(std::ranges::find(before, j.id) != before.end());
    item->setToolTip(2, QString::fromStdString(j.outcome.error));
    item->setDisabled(j.state == JobState::cancelled);
  }
  enable_buttons();
}

std::vector<int> HistoryPanel::chosen() const {
  std::vector<int> ids;
  for (const auto* item : list_->selectedItems()) ids.push_back(item->data(0, id_role).toInt());
  std::ranges::sort(ids);
  return ids;
}

void HistoryPanel::enable_buttons() {
  const auto n = chosen().size();
  show_->setEnabled(n == 1);
  take_->setEnabled(n == 1);
  compare_->setEnabled(n == 2);
}

void HistoryPanel::show_run() {
  const auto ids = chosen();
  if (ids.size() != 1) return;
  try {
    runs_.show_again(ids.front());
  } catch (const Error& e) {
    Q_EMIT refused(QString::fromUtf8(e.what()));
  }
}

void HistoryPanel::take_options() {
  const auto ids = chosen();
  const auto job = ids.size() == 1 ? runs_.job(ids.front()) : nullptr;
  if (!job || !session_.has_document()) return;
  auto& stack = session_.undo_stack();
  const auto changes = changed_options(session_.document(), *job->document);
  if (changes.empty()) return;
  stack.beginMacro(tr("options of run %1").arg(job->id));
  try {
    for (const auto& c : changes)
      session_.set_option(c.stage, c.option, job->document->at(c.stage).options.get(c.option));
  } catch (const Error& e) {
    Q_EMIT refused(QString::fromUtf8(e.what()));
  }
  stack.endMacro();
}

}  // namespace bole::desktop
