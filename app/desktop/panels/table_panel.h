// A table of a stage's output: stems, matches, sections.
#pragma once

#include <QAbstractTableModel>
#include <QTableView>
#include <memory>

#include "cloud/table.h"

namespace bole::desktop {

class TableModel : public QAbstractTableModel {
  Q_OBJECT

 public:
  using QAbstractTableModel::QAbstractTableModel;
  void show(std::shared_ptr<const Table> table);

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  std::shared_ptr<const Table> table_;
};

class TablePanel : public QTableView {
  Q_OBJECT

 public:
  explicit TablePanel(QWidget* parent);
  void show_table(std::shared_ptr<const Table> table) { model_.show(std::move(table)); }

 private:
  TableModel model_;
};

}  // namespace bole::desktop
