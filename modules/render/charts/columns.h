// Columns of tables that a figure can do without.
#pragma once

#include <cmath>
#include <limits>

#include "cloud/table.h"

namespace bole::render {

// The numbers of a column, or NaN in every row when the table lacks it.
inline std::vector<double> numbers_or_nan(const Table& table, std::string_view name) {
  if (const auto* values = table.find(name);
      values == nullptr || std::holds_alternative<std::vector<std::string>>(*values))
    return std::vector<double>(table.rows(), std::numeric_limits<double>::quiet_NaN());
  return table.numbers(name);
}

// The words of a column, or empty ones.
inline std::vector<std::string> texts_or_empty(const Table& table, std::string_view name) {
  if (const auto* values = table.find(name))
    if (const auto* texts = std::get_if<std::vector<std::string>>(values)) return *texts;
  return std::vector<std::string>(table.rows());
}

}  // namespace bole::render
