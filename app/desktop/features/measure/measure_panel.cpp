#include "features/measure/measure_panel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace bole::desktop {
namespace {

int top_level_of(const QTreeWidget& tree, QTreeWidgetItem* item) {
  while (item != nullptr && item->parent() != nullptr) item = item->parent();
  return tree.indexOfTopLevelItem(item);
}

}  // namespace

MeasurePanel::MeasurePanel(QWidget* parent)
    : QWidget(parent),
      tree_(new QTreeWidget(this)),
      remove_(new QPushButton(tr("Delete"), this)),
      export_(new QPushButton(tr("Export CSV…"), this)) {
  tree_->setObjectName("measurements");
  tree_->setHeaderLabels({tr("Measurement"), tr("Value"), tr("Unit")});
  tree_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::SelectedClicked);
  tree_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  tree_->setToolTip(tr("Double click: look at it. F2: rename."));
  remove_->setObjectName("measure_delete");
  export_->setObjectName("measure_export");
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(remove_);
  buttons->addWidget(export_);
  buttons->addStretch();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(tree_);
  layout->addLayout(buttons);
  connect(tree_, &QTreeWidget::currentItemChanged, this, [this] {
    if (!following_) Q_EMIT selection_changed(selected());
  });
  connect(tree_, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item) {
    if (!following_ && item->parent() == nullptr) Q_EMIT renamed(tree_->indexOfTopLevelItem(item), item->text(0));
  });
  connect(tree_, &QTreeWidget::itemDoubleClicked, this,
          [this](QTreeWidgetItem* item) { Q_EMIT zoom_asked(top_level_of(*tree_, item)); });
  connect(remove_, &QPushButton::clicked, this, [this] {
    if (selected() >= 0) Q_EMIT remove_asked(selected());
  });
  connect(export_, &QPushButton::clicked, this, &MeasurePanel::export_asked);
}

void MeasurePanel::show_list(const std::vector<render::Measurement>& list) {
  const int before = selected();
  following_ = true;
  tree_->clear();
  for (const auto& m : list) {
    const auto values = render::values_of(m);
    auto* item = new QTreeWidgetItem(tree_, {QString::fromStdString(m.name)});
    item->setFlags(item->flags() | Qt::ItemIsEditable);
    for (const auto& v : values) {
      const QStringList cells{QString::fromStdString(v.name), QString::number(v.value, 'f', v.decimals),
                              QString::fromStdString(v.unit)};
      auto* row = new QTreeWidgetItem(item, cells);
      row->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
    }
    if (!values.empty()) {
      const bool height = m.kind == render::Measurement::Kind::point && m.height_above_ground_m.has_value();
      const auto& first = m.kind == render::Measurement::Kind::point ? values[height ? 3 : 2] : values.front();
      item->setText(1, QString::number(first.value, 'f', first.decimals));
      item->setText(2, QString::fromStdString(first.unit));
      item->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
    }
  }
  following_ = false;
  select(before < tree_->topLevelItemCount() ? before : -1);
  remove_->setEnabled(!list.empty());
  export_->setEnabled(!list.empty());
}

void MeasurePanel::select(int which) {
  following_ = true;
  tree_->setCurrentItem(tree_->topLevelItem(which));
  following_ = false;
}

int MeasurePanel::selected() const { return top_level_of(*tree_, tree_->currentItem()); }

}  // namespace bole::desktop
