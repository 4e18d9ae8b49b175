// The line above a table as a filter of its rows: words, and conditions on columns.
#pragma once

#include <QSortFilterProxyModel>
#include <optional>
#include <string>
#include <vector>

#include "cloud/table.h"

namespace bole::desktop {

// `poor check` : rows that hold both words in some cell. `dbh_cm > 20`, `quality = poor`, `state != edited`,
// `reasons ~ arc`: conditions; all must hold. A column may be named without its unit (`dbh > 20`), a text with blanks
// in double quotes. Missing numbers meet no condition but `!=`.
class RowCondition {
 public:
  static std::vector<RowCondition> parse(const std::string& text, const Table* table);

  bool holds(const Table& table, std::size_t row) const;
  // Why it can hold in no row: a column that is not there, a number that is none; empty when it can.
  const std::string& problem() const { return problem_; }

 private:
  enum class Relation { contains, equal, unequal, less, less_equal, greater, greater_equal };
  Relation relation_ = Relation::contains;
  std::string column_;  // empty: any
  std::string text_;    // lower case
  std::optional<double> number_;
  std::string problem_;
};

// Sorts by the numbers themselves (Qt::UserRole) and shows the rows that meet a text of conditions.
class RowFilter : public QSortFilterProxyModel {
  Q_OBJECT

 public:
  explicit RowFilter(QObject* parent);
  void set_table(const Table* table);
  // The order of the rows while no column is sorted by: rank[row], the smallest first.
  void set_ranks(std::vector<std::size_t> ranks);
  void set_text(const QString& text);
  void sort_by_rank();
  void sort(int column, Qt::SortOrder order) override;
  QString problem() const;  // a sentence about the first condition that no row can meet

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;
  bool lessThan(const QModelIndex& left, const QModelIndex& right) const override;

 private:
  const Table* table_ = nullptr;
  QString text_;
  std::vector<std::size_t> ranks_;
  bool by_rank_ = false;
  std::vector<RowCondition> conditions_;
};

}  // namespace bole::desktop
