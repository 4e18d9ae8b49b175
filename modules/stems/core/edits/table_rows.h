// A table that rows can be added to, changed in and taken from.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "cloud/table.h"

namespace bole::stems {

// Measured columns (names that end in a unit) become decimals: a file with whole centimetres alone must be able to take
// 23.4 or a missing number.
class TableRows {
 public:
  explicit TableRows(const Table& table);

  std::size_t size() const { return rows_.size(); }
  bool has(std::string_view column) const { return index(column) < names_.size(); }

  // NaN, 0 and "" where the column is absent.
  double number(std::size_t row, std::string_view column) const;
  std::int64_t integer(std::size_t row, std::string_view column) const;

  // Nothing happens where the column is absent: tables of other programs have fewer. What the column cannot hold makes
  // it one that can: decimals or a missing number in whole numbers, a text in numbers.
  void set(std::size_t row, std::string_view column, double value);
  void set(std::size_t row, std::string_view column, std::int64_t value);
  void set(std::size_t row, std::string_view column, const std::string& value);

  // Adds a column of empty texts or missing numbers unless it is there, and makes one of another type such a column.
  void want_texts(const std::string& column);
  void want_numbers(const std::string& column);

  std::size_t add();  // a row of NaN, 0 and ""
  void remove(std::size_t row) { rows_.erase(rows_.begin() + static_cast<std::ptrdiff_t>(row)); }

  Table table() const;

 private:
  using Cell = std::variant<double, std::int64_t, std::string>;
  std::size_t index(std::string_view column) const;
  template <class T>
  void want(const std::string& column, const T& empty, T (*converted)(const Cell&));

  std::vector<std::string> names_;
  std::vector<Cell> empty_;  // what a new row holds, hence also the types
  std::vector<std::vector<Cell>> rows_;
  Facts facts_;
};

}  // namespace bole::stems
