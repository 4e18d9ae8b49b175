// A table of a stage's output for Qt's views: stems, matches, rows.
#pragma once

#include <QAbstractTableModel>
#include <memory>

#include "cloud/table.h"

namespace bole::desktop {

class TableModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  using QAbstractTableModel::QAbstractTableModel;
  void show(std::shared_ptr<const Table> table);
  const Table* table() const { return table_.get(); }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  std::shared_ptr<const Table> table_;
};

}  // namespace bole::desktop
