#include "panels/table_panel.h"

#include <QHeaderView>
#include <QMenu>
#include <QScrollBar>
#include <QSettings>
#include <algorithm>
#include <array>

#include "render/charts/worst_first.h"

namespace bole::desktop {
namespace {

// What is read first stands first, whatever the order in files.
constexpr std::array first_columns{"tree_id", "quality", "state", "dbh_cm", "dbh_lo_cm", "dbh_hi_cm", "height_m"};
constexpr const char *frozen_column = "tree_id", *hidden_setting = "stem_table/hidden",
                     *order_setting = "stem_table/order";
constexpr int max_column_px = 220, looked_at_rows = 50;

std::vector<std::size_t> ranks_of(const Table* table) {
  if (table == nullptr || !table->has("dbh_cm")) return {};
  const auto order = render::worst_first(*table);
  std::vector<std::size_t> ranks(order.size());
  for (std::size_t place = 0; place < order.size(); ++place) ranks[order[place]] = place;
  return ranks;
}

}  // namespace

TablePanel::TablePanel(Selection& selection, QWidget* parent)
    : QTableView(parent),
      selection_(selection),
      model_(this),
      rows_(new RowFilter(this)),
      frozen_(new QTableView(this)) {
  rows_->setSourceModel(&model_);
  setModel(rows_);
  setSortingEnabled(true);
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setSelectionMode(QAbstractItemView::ExtendedSelection);
  setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  setAlternatingRowColors(true);
  verticalHeader()->hide();
  horizontalHeader()->setMaximumSectionSize(max_column_px);
  horizontalHeader()->setResizeContentsPrecision(looked_at_rows);
  horizontalHeader()->setSectionsMovable(true);
  horizontalHeader()->setContextMenuPolicy(Qt::CustomContextMenu);
  verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
  connect(horizontalHeader(), &QWidget::customContextMenuRequested, this, [this](const QPoint& at) {
    QMenu menu;
    fill_column_menu(menu);
    menu.exec(horizontalHeader()->mapToGlobal(at));
  });
  connect(horizontalHeader(), &QHeaderView::sectionMoved, this, [this] {
    if (!arranging_) keep_columns();
  });
  make_frozen();
  sort_worst_first();
  connect(selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
    if (const auto id = selected_tree(); id && !following_) selection_.select(id);
  });
  connect(&selection_, &Selection::changed, this, [this] {
    if (selection_.tree() != selected_tree()) select_tree(selection_.tree().value_or(-1));
  });
}

// The same model and selection once more, over the left edge.
void TablePanel::make_frozen() {
  frozen_->setModel(rows_);
  frozen_->setSelectionModel(selectionModel());
  frozen_->setSelectionBehavior(QAbstractItemView::SelectRows);
  frozen_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  frozen_->setFocusPolicy(Qt::NoFocus);
  frozen_->setFrameShape(QFrame::NoFrame);
  frozen_->setAlternatingRowColors(true);
  frozen_->verticalHeader()->hide();
  frozen_->verticalHeader()->setDefaultSectionSize(verticalHeader()->defaultSectionSize());
  frozen_->horizontalHeader()->setSectionsClickable(true);
  frozen_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  frozen_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  frozen_->setVerticalScrollMode(verticalScrollMode());
  frozen_->setContextMenuPolicy(Qt::NoContextMenu);  // that of the table
  connect(frozen_->verticalScrollBar(), &QScrollBar::valueChanged, verticalScrollBar(), &QScrollBar::setValue);
  connect(verticalScrollBar(), &QScrollBar::valueChanged, frozen_->verticalScrollBar(), &QScrollBar::setValue);
  connect(horizontalHeader(), &QHeaderView::sectionResized, this, [this] { place_frozen(); });
  connect(frozen_->horizontalHeader(), &QHeaderView::sectionClicked, this, [this](int column) {
    sortByColumn(column, horizontalHeader()->sortIndicatorOrder() == Qt::AscendingOrder &&
                                 horizontalHeader()->sortIndicatorSection() == column
                             ? Qt::DescendingOrder
                             : Qt::AscendingOrder);
  });
  viewport()->stackUnder(frozen_);
}

void TablePanel::place_frozen() {
  const int column = model_.column_of(frozen_column);
  frozen_->setVisible(column >= 0 && !isColumnHidden(column) && horizontalHeader()->visualIndex(column) == 0);
  if (!frozen_->isVisibleTo(this)) return;
  for (int other = 0; other < model_.columnCount(); ++other) frozen_->setColumnHidden(other, other != column);
  frozen_->setColumnWidth(column, columnWidth(column));
  frozen_->horizontalHeader()->setFixedHeight(horizontalHeader()->height());
  frozen_->setGeometry(frameWidth(), frameWidth(), columnWidth(column),
                       viewport()->height() + horizontalHeader()->height());
}

void TablePanel::resizeEvent(QResizeEvent* event) {
  QTableView::resizeEvent(event);
  place_frozen();
}

// A cell under the frozen column is not seen.
QModelIndex TablePanel::moveCursor(CursorAction action, Qt::KeyboardModifiers modifiers) {
  const auto index = QTableView::moveCursor(action, modifiers);
  if (action == MoveLeft && frozen_->isVisible() && index.isValid() &&
      columnViewportPosition(index.column()) < frozen_->width())
    horizontalScrollBar()->setValue(horizontalScrollBar()->value() + columnViewportPosition(index.column()) -
                                    frozen_->width());
  return index;
}

void TablePanel::scrollTo(const QModelIndex& index, ScrollHint hint) {
  const int middle = horizontalHeader()->logicalIndexAt(viewport()->width() / 2);  // is seen: nothing moves sideways
  const bool frozen = index.column() == model_.column_of(frozen_column) && middle >= 0;
  QTableView::scrollTo(frozen ? index.siblingAtColumn(middle) : index, hint);
}

void TablePanel::show_table(const std::shared_ptr<const Table>& table) {
  following_ = true;
  const auto several = selected_trees();
  rows_->set_table(table.get());
  rows_->set_ranks({});
  model_.show(table);
  rows_->set_ranks(ranks_of(table.get()));
  arrange_columns();
  if (several.size() > 1)
    reselect(several);
  else if (selection_.tree())
    select_tree(*selection_.tree());
  following_ = false;
}

void TablePanel::arrange_columns() {
  auto& header = *horizontalHeader();
  arranging_ = true;
  int place = 0;
  for (const char* name : first_columns)
    if (const int column = model_.column_of(name); column >= 0) header.moveSection(header.visualIndex(column), place++);
  restore_columns();
  resizeColumnsToContents();
  arranging_ = false;
  place_frozen();
}

// As the person arranged them last. Columns that were not there then keep their place.
void TablePanel::restore_columns() {
  const QSettings settings;
  const auto hidden = settings.value(hidden_setting).toStringList();
  for (int column = 0; column < model_.columnCount(); ++column)
    setColumnHidden(column, hidden.contains(model_.headerData(column, Qt::Horizontal, column_name_role).toString()));
  auto& header = *horizontalHeader();
  int place = 0;
  for (const auto& name : settings.value(order_setting).toStringList())
    if (const int column = model_.column_of(name.toStdString()); column >= 0)
      header.moveSection(header.visualIndex(column), place++);
}

void TablePanel::keep_columns() {
  QStringList order, hidden;
  for (int place = 0; place < model_.columnCount(); ++place) {
    const int column = horizontalHeader()->logicalIndex(place);
    const auto name = model_.headerData(column, Qt::Horizontal, column_name_role).toString();
    order << name;
    if (isColumnHidden(column)) hidden << name;
  }
  QSettings settings;
  settings.setValue(order_setting, order);
  settings.setValue(hidden_setting, hidden);
  place_frozen();
}

void TablePanel::fill_column_menu(QMenu& menu) {
  for (int place = 0; place < model_.columnCount(); ++place) {
    const int column = horizontalHeader()->logicalIndex(place);
    if (column == model_.column_of(frozen_column)) continue;
    auto* action = menu.addAction(model_.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString());
    action->setToolTip(model_.headerData(column, Qt::Horizontal, Qt::ToolTipRole).toString());
    action->setCheckable(true);
    action->setChecked(!isColumnHidden(column));
    connect(action, &QAction::toggled, this, [this, column](bool on) {
      setColumnHidden(column, !on);
      if (on) resizeColumnToContents(column);
      keep_columns();
    });
  }
  if (menu.isEmpty()) return;
  menu.addSeparator();
  connect(menu.addAction(tr("All columns in their usual order")), &QAction::triggered, this, [this] {
    QSettings().remove("stem_table");
    arrange_columns();
  });
}

void TablePanel::sort_worst_first() {
  horizontalHeader()->setSortIndicator(-1, Qt::AscendingOrder);
  rows_->sort_by_rank();
}

bool TablePanel::worst_first() const { return horizontalHeader()->sortIndicatorSection() < 0; }

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
  const auto current = currentIndex();
  const bool several = current.isValid() && selectionModel()->isRowSelected(current.row(), {});
  const auto index = rows_->mapToSource(several ? current : rows.front());
  return static_cast<std::size_t>(index.row());
}

std::optional<std::int64_t> TablePanel::selected_tree() const {
  const auto row = selected_row();
  if (!row || !model_.table()->has("tree_id")) return {};
  return model_.table()->integers("tree_id")[*row];
}

std::vector<std::int64_t> TablePanel::selected_trees() const {
  std::vector<std::int64_t> trees;
  if (model_.table() == nullptr || !model_.table()->has("tree_id")) return trees;
  auto rows = selectionModel()->selectedRows();
  std::sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.row() < b.row(); });
  const auto ids = model_.table()->integers("tree_id");
  for (const auto& index : rows) trees.push_back(ids[static_cast<std::size_t>(rows_->mapToSource(index).row())]);
  return trees;
}

void TablePanel::reselect(const std::vector<std::int64_t>& trees) {
  QItemSelection all;
  for (const auto tree : trees)
    if (const auto row = row_of(tree)) {
      const auto index = rows_->mapFromSource(model_.index(static_cast<int>(*row), 0));
      if (index.isValid()) all.select(index, index);
    }
  selectionModel()->select(all, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
}

std::vector<int> TablePanel::columns_in_order() const {
  std::vector<int> columns;
  for (int place = 0; place < model_.columnCount(); ++place)
    if (const int column = horizontalHeader()->logicalIndex(place); !isColumnHidden(column)) columns.push_back(column);
  return columns;
}

QString TablePanel::selected_text() const {
  QStringList lines;
  const auto columns = columns_in_order();
  const auto line = [&](const auto& cell) {
    QStringList cells;
    for (const int column : columns) cells << cell(column);
    lines << cells.join('\t');
  };
  line([&](int column) { return model_.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString(); });
  auto rows = selectionModel()->selectedRows();
  std::sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.row() < b.row(); });
  for (const auto& row : rows)
    line([&](int column) { return row.siblingAtColumn(column).data(Qt::UserRole).toString().simplified(); });
  return lines.join('\n') + '\n';
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
  // selectRow() would look at the keyboard: with Ctrl held, as in Ctrl+Right, the tree before stayed selected too, and
  // was decided with this one.
  selectionModel()->setCurrentIndex(index, QItemSelectionModel::ClearAndSelect | QItemSelectionModel::Rows);
  scrollTo(index);
}

}  // namespace bole::desktop
