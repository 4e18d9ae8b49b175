#include "cloud/table_columns.h"

#include <limits>

namespace bole {
inline namespace cloud {

std::vector<double> numbers_or_nan(const Table& table, std::string_view name) {
  if (const auto* values = table.find(name);
      values == nullptr || std::holds_alternative<std::vector<std::string>>(*values))
    return std::vector<double>(table.rows(), std::numeric_limits<double>::quiet_NaN());
  return table.numbers(name);
}

std::vector<std::string> texts_or_empty(const Table& table, std::string_view name) {
  if (const auto* values = table.find(name))
    if (const auto* texts = std::get_if<std::vector<std::string>>(values)) return *texts;
  return std::vector<std::string>(table.rows());
}

}  // namespace cloud
}  // namespace bole
