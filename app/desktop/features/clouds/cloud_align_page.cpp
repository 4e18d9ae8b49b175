#include "features/clouds/cloud_align_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "features/clouds/cloud_jobs.h"
#include "features/clouds/cloud_pairs.h"
#include "features/clouds/cloud_widgets.h"
#include "features/clouds/clouds.h"
#include "workbench/workbench.h"

namespace bole::desktop {

void list_partners(QComboBox& box, const Clouds& clouds, int but) {
  const int before = box.currentData().toInt();
  box.clear();
  box.addItem(CloudAlignPage::tr("the survey"), 0);
  for (const auto& cloud : clouds.list())
    if (cloud.id != but && cloud.read) box.addItem(cloud.name(), cloud.id);
  box.setCurrentIndex(std::max(0, box.findData(before)));
}

CloudAlignPage::CloudAlignPage(Clouds& clouds, CloudPairs& pairs, CloudJobs& jobs, Workbench& bench)
    : clouds_(clouds),
      pairs_(pairs),
      jobs_(jobs),
      bench_(bench),
      next_(new QLabel),
      said_(new QLabel),
      fine_said_(new QLabel),
      list_(new QTreeWidget),
      scale_(new QCheckBox(tr("With scale"))),
      onto_(new QComboBox) {
  auto* column = new QVBoxLayout(this);
  for (auto* label : {next_, said_, fine_said_}) {
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  }
  next_->setObjectName("cloud_next_click");
  said_->setObjectName("cloud_pairs_said");
  fine_said_->setObjectName("cloud_fine_said");
  make_list();
  scale_->setObjectName("cloud_pairs_scale");
  scale_->setToolTip(tr("The pairs give the scale too. Surveys by laser have none to give: leave it off"));
  connect(scale_, &QCheckBox::toggled, this, [this](bool on) {
    if (!following_) pairs_.set_with_scale(on);
  });
  column->addWidget(make_buttons());
  column->addWidget(next_);
  column->addWidget(list_, 1);
  column->addWidget(said_);
  auto* row = new QHBoxLayout;
  auto* move = new QToolButton;
  put_action(*move, *bench_.commands().action("clouds.move_by_pairs"), tr("Move by the pairs"));
  row->addWidget(move);
  row->addWidget(scale_);
  row->addStretch();
  column->addLayout(row);
  column->addWidget(make_fine());
  connect(&pairs_, &CloudPairs::changed, this, &CloudAlignPage::follow_pairs);
}

void CloudAlignPage::make_list() {
  list_->setObjectName("cloud_pairs");
  list_->setHeaderLabels({tr("Pair"), tr("Onto"), tr("Residual")});
  list_->setRootIsDecorated(false);
  list_->setMinimumHeight(6 * list_->fontMetrics().height());
  list_->setToolTip(
      tr("Pairs without a tick do not count; their residual is shown all the same. The largest is bold."));
  list_->header()->setStretchLastSection(false);
  list_->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  list_->header()->setSectionResizeMode(1, QHeaderView::Stretch);
  list_->header()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
  connect(list_, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item) {
    if (!following_) pairs_.use(cloud_, list_->indexOfTopLevelItem(item), item->checkState(0) == Qt::Checked);
  });
  connect(list_, &QTreeWidget::currentItemChanged, this, [this] {
    if (following_) return;
    pairs_.show(cloud_, selected_pair());
    bench_.commands().update();
  });
}

QWidget* CloudAlignPage::make_buttons() {
  return button_row(bench_.commands(), {{"clouds.pick_pairs", tr("Pick pairs")},
                                        {"clouds.remove_pair", tr("Remove")},
                                        {"clouds.clear_pairs", tr("Clear")}});
}

QWidget* CloudAlignPage::make_fine() {
  auto* box = new QWidget;
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 8, 0, 0);
  column->addWidget(new QLabel("<b>" + tr("Fine registration") + "</b>"));
  auto* form = new QFormLayout;
  onto_->setObjectName("cloud_fine_onto");
  onto_->setToolTip(tr("What the cloud is fitted to; it stays where it is"));
  onto_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  form->addRow(tr("Onto"), onto_);
  reach_ = cloud_number("cloud_fine_reach", tr("How far apart the same place in both may be at the start"),
                        {0.05, 10, 0.1, 2, tr(" m")});
  reach_->setValue(alignment::FineOptions().reach_m);
  form->addRow(tr("Look within"), reach_);
  column->addLayout(form);
  auto* fit = new QToolButton;
  put_action(*fit, *bench_.commands().action("clouds.fit_finely"), tr("Fit finely"));
  column->addWidget(fit, 0, Qt::AlignLeft);
  column->addWidget(fine_said_);
  return box;
}

int CloudAlignPage::selected_pair() const {
  return list_->currentItem() == nullptr ? -1 : list_->indexOfTopLevelItem(list_->currentItem());
}

int CloudAlignPage::onto() const { return onto_->currentData().toInt(); }

double CloudAlignPage::reach_m() const { return reach_->value(); }

void CloudAlignPage::follow(const CloudEntry* cloud) {
  setEnabled(cloud != nullptr);
  cloud_ = cloud == nullptr ? 0 : cloud->id;
  list_partners(*onto_, clouds_, cloud_);
  const QString fine = jobs_.said_of_fine(cloud_);
  fine_said_->setText(fine);
  fine_said_->setVisible(!fine.isEmpty());
  follow_pairs();
  pairs_.show(cloud_, selected_pair());
}

// An item that was ticked just now stays: it is in use by its list.
void CloudAlignPage::follow_pairs() {
  const auto& pairs = pairs_.of(cloud_);
  const auto solution = pairs_.solve(cloud_);
  const int count = static_cast<int>(pairs.size()), shown = list_->topLevelItemCount();
  following_ = true;
  while (list_->topLevelItemCount() > count) delete list_->takeTopLevelItem(list_->topLevelItemCount() - 1);
  while (list_->topLevelItemCount() < count) new QTreeWidgetItem(list_);
  double largest_m = 0;
  for (std::size_t k = 0; k < pairs.size(); ++k)
    if (pairs[k].used && std::isfinite(solution.residual_m[k])) largest_m = std::max(largest_m, solution.residual_m[k]);
  for (int k = 0; k < count; ++k) {
    const auto& pair = pairs[static_cast<std::size_t>(k)];
    const double residual_m = solution.residual_m[static_cast<std::size_t>(k)];
    const auto* other = pair.onto == 0 ? nullptr : clouds_.find(pair.onto);
    auto& item = *list_->topLevelItem(k);
    item.setText(0, QString::number(k + 1));
    item.setFlags(item.flags() | Qt::ItemIsUserCheckable);
    item.setCheckState(0, pair.used ? Qt::Checked : Qt::Unchecked);
    item.setText(1, pair.onto == 0 ? tr("the survey") : other == nullptr ? tr("removed") : other->name());
    item.setText(2, std::isfinite(residual_m) ? tr("%1 m").arg(residual_m, 0, 'f', 3) : QStringLiteral("–"));
    item.setTextAlignment(2, Qt::AlignRight | Qt::AlignVCenter);
    auto font = list_->font();
    font.setBold(pair.used && count > 3 && residual_m == largest_m);
    item.setFont(2, font);
  }
  if (count > shown) list_->setCurrentItem(list_->topLevelItem(count - 1));
  scale_->setChecked(pairs_.with_scale());
  following_ = false;
  QString words;
  if (solution.fit) {
    words = tr("%1 pairs, RMS %2 m").arg(solution.used).arg(solution.fit->rms_m, 0, 'f', 3);
    if (pairs_.with_scale()) words += ", " + tr("scale %1").arg(solution.fit->motion.scale, 0, 'f', 5);
  } else if (solution.problem == alignment::PairProblem::on_a_line) {
    words = tr("The %1 points lie on a line: the turn about it is not known. Pick one beside it.").arg(solution.used);
  } else {
    words = tr("%1 of at least 3 pairs").arg(solution.used);
  }
  said_->setText(words);
  next_->setText(pairs_.next_click());
  next_->setVisible(pairs_.picking());
}

}  // namespace bole::desktop
