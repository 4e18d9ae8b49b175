#include "panels/table_model.h"

namespace bole::desktop {

void TableModel::show(std::shared_ptr<const Table> table) {
  beginResetModel();
  table_ = std::move(table);
  endResetModel();
}

int TableModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() || !table_ ? 0 : static_cast<int>(table_->rows());
}
int TableModel::columnCount(const QModelIndex& parent) const {
  return parent.isValid() || !table_ ? 0 : static_cast<int>(table_->columns().size());
}

QVariant TableModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || !table_) return {};
  const auto& column = table_->columns()[static_cast<std::size_t>(index.column())];
  const auto row = static_cast<std::size_t>(index.row());
  const bool number = !std::holds_alternative<std::vector<std::string>>(column.values);
  if (role == Qt::TextAlignmentRole)
    return static_cast<int>((number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  if (role == Qt::DisplayRole)
    return QString::fromStdString(table_->text(column.name, row, column.name.ends_with("_m") ? 3 : 2));
  // Sorting takes the number itself, not its text.
  if (role == Qt::UserRole && number) return table_->numbers(column.name)[row];
  if (role == Qt::UserRole) return QString::fromStdString(table_->texts(column.name)[row]);
  return {};
}

QVariant TableModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (role != Qt::DisplayRole || orientation != Qt::Horizontal || !table_) return {};
  return QString::fromStdString(table_->columns()[static_cast<std::size_t>(section)].name);
}

}  // namespace bole::desktop
