// The stem table: its selection is that of the window.
#pragma once

#include <QTableView>
#include <memory>
#include <optional>

#include "document/selection.h"
#include "panels/row_filter.h"
#include "panels/table_model.h"

namespace bole::desktop {

class TablePanel : public QTableView {
  Q_OBJECT

 public:
  TablePanel(Selection& selection, QWidget* parent);
  void show_table(std::shared_ptr<const Table> table);  // the selection stays
  // Shows the rows that meet the conditions of row_filter.h; returns a sentence when no row can.
  QString filter(const QString& text);

  void select_tree(std::int64_t id);
  std::optional<std::int64_t> selected_tree() const;

 private:
  std::optional<std::size_t> selected_row() const;             // of the table, whatever the sorting
  std::optional<std::size_t> row_of(std::int64_t tree) const;  // likewise
  void arrange_columns();

  Selection& selection_;
  TableModel model_;
  RowFilter* rows_;
  bool following_ = false;  // the selection is shown, not made
};

}  // namespace bole::desktop
