// A table of named columns: stems, rows, targets, reference trees. A missing number is NaN, a missing text is empty.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "cloud/facts.h"

namespace bole {
inline namespace cloud {

class Table {
 public:
  using Values = std::variant<std::vector<double>, std::vector<std::int64_t>, std::vector<std::string>>;
  struct NamedColumn {
    std::string name;  // with its unit, as in files: "x_m", "dbh_cm"
    Values values;
  };

  Facts facts;

  std::size_t rows() const { return rows_; }
  const std::vector<NamedColumn>& columns() const { return columns_; }
  bool has(std::string_view name) const { return find(name) != nullptr; }
  const Values* find(std::string_view name) const;

  // Adds or replaces a column. The first column sets the number of rows; later ones must agree (Error{failed}).
  void set(std::string_view name, Values values);
  void remove(std::string_view name);

  // Typed access; numbers() also turns whole numbers into doubles. Throws Error{bad_input} when absent or of another
  // type.
  std::vector<double> numbers(std::string_view name) const;
  std::vector<std::int64_t> integers(std::string_view name) const;
  const std::vector<std::string>& texts(std::string_view name) const;

  // One cell as text, numbers with up to `decimals` digits after the point (shortest exact when negative).
  std::string text(std::string_view name, std::size_t row, int decimals = -1) const;

  // The rows of `indices` in that order.
  Table subset(const std::vector<std::size_t>& indices) const;

 private:
  std::size_t rows_ = 0;
  std::vector<NamedColumn> columns_;
};

}  // namespace cloud
}  // namespace bole
