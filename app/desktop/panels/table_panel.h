// The stem table: its selection is that of the window.
#pragma once

#include <QTableView>
#include <memory>
#include <optional>
#include <vector>

#include "document/selection.h"
#include "panels/row_filter.h"
#include "panels/table_model.h"

class QMenu;

namespace bole::desktop {

class TablePanel : public QTableView {
  Q_OBJECT

 public:
  TablePanel(Selection& selection, QWidget* parent);
  void show_table(const std::shared_ptr<const Table>& table);  // the selection stays
  // Shows the rows that meet the conditions of row_filter.h; returns a sentence when no row can.
  QString filter(const QString& text);

  void select_tree(std::int64_t id);
  std::optional<std::int64_t> selected_tree() const;  // the last one of several
  std::vector<std::int64_t> selected_trees() const;   // in the order in which they stand
  void sort_worst_first();
  bool worst_first() const;
  QString selected_text() const;       // rows with the shown columns, for a spreadsheet: tabs between cells
  void fill_column_menu(QMenu& menu);  // which columns are shown

 protected:
  void resizeEvent(QResizeEvent* event) override;
  QModelIndex moveCursor(CursorAction action, Qt::KeyboardModifiers modifiers) override;
  void scrollTo(const QModelIndex& index, ScrollHint hint = EnsureVisible) override;

 private:
  std::optional<std::size_t> selected_row() const;             // of the table, whatever the sorting
  std::optional<std::size_t> row_of(std::int64_t tree) const;  // likewise
  void arrange_columns();
  void restore_columns();
  void keep_columns();
  void make_frozen();
  void place_frozen();
  void reselect(const std::vector<std::int64_t>& trees);
  std::vector<int> columns_in_order() const;  // those that are shown

  Selection& selection_;
  TableModel model_;
  RowFilter* rows_;
  QTableView* frozen_;      // the number of the tree, which stays while the columns scroll
  bool following_ = false;  // the selection is shown, not made
  bool arranging_ = false;  // columns are moved by the program
};

}  // namespace bole::desktop
