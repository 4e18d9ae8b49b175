#include "panels/table_model.h"

#include <QBrush>
#include <QFont>
#include <QGuiApplication>
#include <QPalette>
#include <algorithm>

#include "cloud/table_columns.h"
#include "document/cell_words.h"
#include "panels/column_words.h"

namespace bole::desktop {

void TableModel::show(std::shared_ptr<const Table> table) {
  beginResetModel();
  table_ = std::move(table);
  states_ = table_ && table_->has("state") ? texts_or_empty(*table_, "state") : std::vector<std::string>();
  endResetModel();
}

int TableModel::column_of(const std::string& name) const {
  if (!table_) return -1;
  const auto& columns = table_->columns();
  const auto it = std::ranges::find_if(columns, [&](const auto& column) { return column.name == name; });
  return it == columns.end() ? -1 : static_cast<int>(it - columns.begin());
}

// What a person decided is seen in every cell of the row: a rejected tree is struck out.
QVariant TableModel::look_of(std::size_t row, int role) const {
  if (row >= states_.size()) return {};
  const auto& state = states_[row];
  if (role == Qt::FontRole && state == "rejected") {
    QFont font;
    font.setStrikeOut(true);
    return font;
  }
  if (role == Qt::ForegroundRole && state == "rejected")
    return QGuiApplication::palette().brush(QPalette::Disabled, QPalette::Text);
  return {};
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
  if (role == Qt::FontRole || role == Qt::ForegroundRole) return look_of(row, role);
  if (role == Qt::TextAlignmentRole)
    return static_cast<int>((number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  if (role == Qt::DisplayRole || (role == Qt::ToolTipRole && !number)) {
    const QString text = QString::fromStdString(table_->text(column.name, row, column.name.ends_with("_m") ? 3 : 2));
    const QString words = cell_words(column.name, text);
    if (role == Qt::ToolTipRole || column.name != "state") return words;
    const char* const mark = text == "accepted" ? "✓ " : text == "rejected" ? "✗ " : text == "edited" ? "✎ " : "";
    return QString::fromUtf8(mark) + words;
  }
  // Sorting takes the number itself, not its text.
  if (role == Qt::UserRole && number) return table_->numbers(column.name)[row];
  if (role == Qt::UserRole) return QString::fromStdString(table_->texts(column.name)[row]);
  return {};
}

QVariant TableModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || !table_ || section < 0 || section >= columnCount()) return {};
  const auto& name = table_->columns()[static_cast<std::size_t>(section)].name;
  if (role == column_name_role) return QString::fromStdString(name);
  if (role == Qt::DisplayRole) return column_words(name).header();
  if (role != Qt::ToolTipRole) return {};
  const auto words = column_words(name);
  const QString own = tr("Column %1 in files and filters").arg(QString::fromStdString(name));
  return words.help.isEmpty() ? own : words.help + "\n" + own;
}

}  // namespace bole::desktop
