// A table of a stage's output: stems, matches, sections.
#pragma once

#include <QAbstractTableModel>
#include <QTableView>
#include <memory>
#include <optional>

#include "cloud/table.h"
#include "panels/row_filter.h"
#include "selection/selection.h"
#include "stems/core/edits/stem_edits.h"

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

// The stem table. Its menu and keys ask for edits; somebody else makes them.
class TablePanel : public QTableView {
  Q_OBJECT

 public:
  TablePanel(Selection& selection, QWidget* parent);
  void show_table(std::shared_ptr<const Table> table);  // what is selected stays so
  // Shows the rows that fulfil the conditions of row_filter.h; a sentence when no row can.
  QString filter(const QString& text);

  void select_tree(std::int64_t id);
  std::optional<std::int64_t> selected_tree() const;

 Q_SIGNALS:
  void edit_requested(const stems::StemEdit& edit);

 protected:
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  std::optional<std::size_t> selected_row() const;             // of the table, whatever the sorting
  std::optional<std::size_t> row_of(std::int64_t tree) const;  // likewise
  // An edit of the stem that is selected, in this table or elsewhere, with its place and diameter.
  std::optional<stems::StemEdit> edit_of_selection(stems::StemEdit::Action action) const;
  void make_actions();
  void arrange_columns();
  void request(stems::StemEdit::Action action);

  Selection& selection_;
  TableModel model_;
  RowFilter* rows_;
  bool following_ = false;  // the selection is shown, not made
};

}  // namespace bole::desktop
