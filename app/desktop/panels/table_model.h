// A table of a stage's output for Qt's views: stems, matches, rows.
#pragma once

#include <QAbstractTableModel>
#include <memory>

#include "cloud/table.h"

namespace bole::desktop {

inline constexpr int column_name_role = Qt::UserRole + 1;  // of headers: the name in the data

class TableModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  using QAbstractTableModel::QAbstractTableModel;
  void show(std::shared_ptr<const Table> table);
  const Table* table() const { return table_.get(); }
  int column_of(const std::string& name) const;  // -1: none

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  QVariant look_of(std::size_t row, int role) const;

  std::shared_ptr<const Table> table_;
  std::vector<std::string> states_;  // decisions of a person; empty where the table has none
};

}  // namespace bole::desktop
