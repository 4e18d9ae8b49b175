#include "panels/table_panel.h"

#include <QAction>
#include <QContextMenuEvent>
#include <QHeaderView>
#include <QInputDialog>
#include <QMenu>
#include <algorithm>
#include <array>
#include <cmath>

namespace bole::desktop {
namespace {

// What is read first stands first, whatever the order in files.
constexpr std::array first_columns{"tree_id", "dbh_cm", "quality", "height_m"};
constexpr int most_column_px = 220, looked_at_rows = 50;

}  // namespace

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

TablePanel::TablePanel(Selection& selection, QWidget* parent)
    : QTableView(parent), selection_(selection), model_(this), rows_(new RowFilter(this)) {
  rows_->setSourceModel(&model_);
  setModel(rows_);
  setSortingEnabled(true);
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setAlternatingRowColors(true);
  verticalHeader()->hide();
  horizontalHeader()->setMaximumSectionSize(most_column_px);
  horizontalHeader()->setResizeContentsPrecision(looked_at_rows);
  verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
  sortByColumn(0, Qt::AscendingOrder);
  setSelectionMode(QAbstractItemView::SingleSelection);
  make_actions();
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

void TablePanel::make_actions() {
  using Action = stems::StemEdit::Action;
  const auto add = [this](const char* id, const QString& text, const QKeySequence& key, Action action) {
    auto* a = new QAction(text, this);
    a->setObjectName(id);
    a->setShortcut(key);
    connect(a, &QAction::triggered, this, [this, action] { request(action); });
    addAction(a);
  };
  add("set_diameter", tr("Set diameter…"), Qt::Key_D, Action::resize);
  add("set_height", tr("Set height…"), Qt::Key_H, Action::set_height);
  add("accept", tr("Accept"), Qt::Key_A, Action::accept);
  add("reject", tr("Reject"), Qt::Key_R, Action::reject);
  add("note", tr("Note…"), Qt::Key_N, Action::note);
  add("delete_stem", tr("Delete"), QKeySequence::Delete, Action::remove);
}

void TablePanel::contextMenuEvent(QContextMenuEvent* event) {
  if (selected_row()) QMenu::exec(actions(), event->globalPos(), nullptr, this);
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

std::optional<stems::StemEdit> TablePanel::edit_of_selection(stems::StemEdit::Action action) const {
  const auto row = selection_.tree() ? row_of(*selection_.tree()) : std::nullopt;
  const auto* table = model_.table();
  if (!row || !table->has("x_m") || !table->has("y_m") || !table->has("dbh_cm")) return {};
  stems::StemEdit edit;
  edit.action = action;
  edit.at = {table->numbers("x_m")[*row], table->numbers("y_m")[*row]};
  edit.was_dbh_cm = table->numbers("dbh_cm")[*row];
  return edit;
}

void TablePanel::request(stems::StemEdit::Action action) {
  auto edit = edit_of_selection(action);
  if (!edit) return;
  bool given = true;
  if (action == stems::StemEdit::Action::resize)
    edit->dbh_cm = QInputDialog::getDouble(this, tr("Diameter"), tr("Diameter at breast height in cm"),
                                           *edit->was_dbh_cm, 0.1, 2000, 1, &given);
  if (action == stems::StemEdit::Action::set_height)
    edit->height_m =
        QInputDialog::getDouble(this, tr("Height"), tr("Height of the tree in m"), 20, 0.1, 200, 1, &given);
  if (action == stems::StemEdit::Action::note)
    edit->text = QInputDialog::getText(this, tr("Note"), tr("Note"), QLineEdit::Normal, {}, &given).toStdString();
  if (given) Q_EMIT edit_requested(*edit);
}

}  // namespace bole::desktop
