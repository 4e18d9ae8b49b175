#include "features/run/jobs_panel.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QStyledItemDelegate>
#include <QTimer>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "look/finding_words.h"
#include "running/runner.h"

namespace bole::desktop {
namespace {

enum Column { run_column, state_column, progress_column, elapsed_column, left_column, columns };
constexpr int job_role = Qt::UserRole, fraction_role = Qt::UserRole + 1;

// A bar with the text of the cell in it, while there is a fraction.
class ProgressDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const auto fraction = index.data(fraction_role);
    if (!fraction.isValid()) return QStyledItemDelegate::paint(painter, option, index);
    QRectF bar = QRectF(option.rect).adjusted(2, 2, -2, -2);
    painter->save();
    painter->fillRect(bar, option.palette.color(QPalette::AlternateBase).darker(106));
    QRectF done = bar;
    done.setWidth(bar.width() * fraction.toDouble());
    QColor color = option.palette.color(QPalette::Highlight);
    color.setAlpha(120);
    painter->fillRect(done, color);
    painter->setPen(option.palette.color(QPalette::Text));
    painter->drawText(
        bar.adjusted(4, 0, -4, 0), Qt::AlignVCenter | Qt::AlignLeft,
        option.fontMetrics.elidedText(index.data().toString(), Qt::ElideRight, static_cast<int>(bar.width()) - 8));
    painter->restore();
  }
};

QString sentence(const Job& job) {
  if (!job.outcome.error.empty()) return finding_words(job.outcome.error);
  QStringList lines;
  for (const auto& stage : job.outcome.stages)
    for (const auto& warning : stage.record.report.warnings)
      lines << QString::fromStdString(stage.record.id) + ": " + finding_words(warning);
  return lines.join('\n');
}

}  // namespace

JobsPanel::JobsPanel(Runner& runs, QWidget* parent)
    : QWidget(parent),
      runs_(runs),
      tree_(new QTreeWidget(this)),
      details_(new QLabel(this)),
      cancel_(new QPushButton(tr("Cancel"), this)),
      finish_(new QPushButton(tr("Keep result"), this)),
      soon_(new QTimer(this)),
      clock_(new QTimer(this)) {
  tree_->setColumnCount(columns);
  tree_->setHeaderLabels({tr("Run"), tr("State"), tr("Progress"), tr("Elapsed"), tr("Left")});
  tree_->setRootIsDecorated(false);
  tree_->setItemDelegateForColumn(progress_column, new ProgressDelegate(tree_));
  tree_->header()->setStretchLastSection(false);
  tree_->header()->setSectionResizeMode(run_column, QHeaderView::Interactive);
  tree_->header()->setSectionResizeMode(progress_column, QHeaderView::Stretch);
  for (const int c : {int{state_column}, int{elapsed_column}, int{left_column}})
    tree_->header()->setSectionResizeMode(c, QHeaderView::ResizeToContents);
  details_->setWordWrap(true);
  details_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  details_->setObjectName("job_details");
  cancel_->setObjectName("cancel_job");
  finish_->setObjectName("finish_job");
  cancel_->setToolTip(tr("Ends the run and throws its work away; a waiting run is taken off the list"));
  finish_->setToolTip(tr("Ends the stage in work with what it has; the stages after it run on that"));
  auto* buttons = new QHBoxLayout;
  auto* said = new QScrollArea(this);  // warnings of many stages are more than the panel has room for
  said->setWidget(details_);
  said->setWidgetResizable(true);
  said->setFrameShape(QFrame::NoFrame);
  said->setFixedHeight(3 * fontMetrics().lineSpacing() + 4);
  details_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  buttons->addWidget(said, 1);
  buttons->addWidget(finish_, 0, Qt::AlignTop);
  buttons->addWidget(cancel_, 0, Qt::AlignTop);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addWidget(tree_);
  layout->addLayout(buttons);

  connect(cancel_, &QPushButton::clicked, this, [this] { runs_.cancel(selected()); });
  connect(finish_, &QPushButton::clicked, &runs_, &Runner::finish);
  connect(tree_, &QTreeWidget::itemSelectionChanged, this, &JobsPanel::show_selected);
  // Progress comes often; the panel follows at a pace that can be read.
  soon_->setSingleShot(true);
  soon_->setInterval(100);
  connect(soon_, &QTimer::timeout, this, &JobsPanel::refresh);
  connect(&runs_, &Runner::jobs_changed, this, [this] {
    if (!soon_->isActive()) soon_->start();
  });
  connect(&runs_, &Runner::job_ended, this, &JobsPanel::refresh);
  clock_->setInterval(1000);
  connect(clock_, &QTimer::timeout, this, &JobsPanel::refresh);
  refresh();
}

int JobsPanel::selected() const {
  if (const auto items = tree_->selectedItems(); !items.isEmpty()) return items.front()->data(0, job_role).toInt();
  return runs_.current() ? runs_.current()->id : 0;
}

void JobsPanel::fill(QTreeWidgetItem* item, const Job& job) const {
  const auto now = Job::Clock::now();
  const auto set = [&](int column, const QString& text) {
    if (item->text(column) != text) item->setText(column, text);
  };
  set(run_column, QString::number(job.id) + "  " + (job.changes.isEmpty() ? job.title : job.changes));
  item->setToolTip(run_column, job.title + (job.changes.isEmpty() ? QString() : "\n" + job.changes));
  set(state_column, job_state_text(job.state));
  set(elapsed_column, job.state == JobState::waiting ? QString() : duration_text(job.elapsed_s(now)));
  if (job.state == JobState::running) {
    set(progress_column, tr("%1 of %2  %3: %4").arg(job.stages_begun).arg(job.stages).arg(job.stage, job.what));
    item->setData(progress_column, fraction_role, job.fraction);
    const auto left = job.left_s(now);
    set(left_column, !left         ? QString()
                     : job.later_s ? duration_text(*left)
                                   : tr("%1 in this stage").arg(duration_text(*left)));
  } else {
    set(progress_column, sentence(job).section('\n', 0, 0));
    item->setData(progress_column, fraction_role, QVariant());
    set(left_column, {});
  }
}

// The newest first. Items are kept, so that the selection stays.
void JobsPanel::refresh() {
  const auto& jobs = runs_.jobs();
  const int n = static_cast<int>(jobs.size());
  const int newest = tree_->topLevelItemCount() > 0 ? tree_->topLevelItem(0)->data(0, job_role).toInt() : 0;
  for (const auto& job : jobs) {
    if (job->id <= newest) continue;
    auto* item = new QTreeWidgetItem;
    item->setData(0, job_role, job->id);
    tree_->insertTopLevelItem(0, item);
  }
  while (tree_->topLevelItemCount() > n) delete tree_->topLevelItem(tree_->topLevelItemCount() - 1);
  for (int i = 0; i < n; ++i) fill(tree_->topLevelItem(i), *jobs[static_cast<std::size_t>(n - 1 - i)]);
  if (runs_.running() != clock_->isActive()) runs_.running() ? clock_->start() : clock_->stop();
  show_selected();
}

void JobsPanel::show_selected() {
  const auto job = runs_.job(selected());
  cancel_->setEnabled(job && !job->over());
  finish_->setEnabled(job && job->state == JobState::running);
  QString text = job ? sentence(*job) : QString();
  if (text.isEmpty() && !runs_.jobs().empty() && runs_.jobs().back()->over()) text = sentence(*runs_.jobs().back());
  if (details_->text() != text) details_->setText(text);
}

}  // namespace bole::desktop
