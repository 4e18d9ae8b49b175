#include "panels/table_panel.h"

#include <QHeaderView>
#include <algorithm>
#include <array>

namespace bole::desktop {
namespace {

// What is read first stands first, whatever the order in files.
constexpr std::array first_columns{"tree_id", "dbh_cm", "quality", "height_m"};
constexpr int max_column_px = 220, looked_at_rows = 50;

}  // namespace

TablePanel::TablePanel(Selection& selection, QWidget* parent)
    : QTableView(parent), selection_(selection), model_(this), rows_(new RowFilter(this)) {
  rows_->setSourceModel(&model_);
  setModel(rows_);
  setSortingEnabled(true);
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setAlternatingRowColors(true);
  verticalHeader()->hide();
  horizontalHeader()->setMaximumSectionSize(max_column_px);
  horizontalHeader()->setResizeContentsPrecision(looked_at_rows);
  verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
  sortByColumn(0, Qt::AscendingOrder);
  setSelectionMode(QAbstractItemView::SingleSelection);
  connect(selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
    if (const auto id = selected_tree(); id && !following_) selection_.select(id);
  });
  connect(&selection_, &Selection::changed, this, [this] {
    if (selection_.tree() != selected_tree()) select_tree(selection_.tree().value_or(-1));
  });
}

void TablePanel::show_table(std::shared_ptr<const Table> table) {
  following_ = true;
  rows_->set_table(table.get());
  model_.show(std::move(table));
  arrange_columns();
  if (selection_.tree()) select_tree(*selection_.tree());
  following_ = false;
}

void TablePanel::arrange_columns() {
  auto& header = *horizontalHeader();
  int place = 0;
  for (const char* name : first_columns)
    for (int column = 0; column < header.count(); ++column)
      if (model_.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString() == QLatin1String(name))
        header.moveSection(header.visualIndex(column), place++);
  resizeColumnsToContents();
}

QString TablePanel::filter(const QString& text) {
  following_ = true;  // the view would select the row after one that is hidden
  rows_->set_text(text);
  if (selection_.tree()) select_tree(*selection_.tree());
  following_ = false;
  return rows_->problem();
}

std::optional<std::size_t> TablePanel::selected_row() const {
  const auto rows = selectionModel()->selectedRows();
  if (rows.isEmpty() || model_.table() == nullptr) return {};
  const auto index = rows_->mapToSource(rows.front());
  return static_cast<std::size_t>(index.row());
}

std::optional<std::int64_t> TablePanel::selected_tree() const {
  const auto row = selected_row();
  if (!row || !model_.table()->has("tree_id")) return {};
  return model_.table()->integers("tree_id")[*row];
}

std::optional<std::size_t> TablePanel::row_of(std::int64_t id) const {
  const auto* table = model_.table();
  if (table == nullptr || !table->has("tree_id")) return {};
  const auto ids = table->integers("tree_id");
  const auto it = std::ranges::find(ids, id);
  if (it == ids.end()) return {};
  return static_cast<std::size_t>(it - ids.begin());
}

void TablePanel::select_tree(std::int64_t id) {
  const auto row = row_of(id);
  const auto index = row ? rows_->mapFromSource(model_.index(static_cast<int>(*row), 0)) : QModelIndex();
  if (!index.isValid()) return clearSelection();  // another table, or hidden by the filter
  selectRow(index.row());
  scrollTo(index);
}

}  // namespace bole::desktop
