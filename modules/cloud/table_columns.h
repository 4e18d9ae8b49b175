// Columns of a table that a reader can do without.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cloud/table.h"

namespace bole {
inline namespace cloud {

// The numbers of a column; NaN in every row where the table has no such column or it holds words.
std::vector<double> numbers_or_nan(const Table& table, std::string_view name);

// The words of a column; empty ones where the table has no such column or it holds numbers.
std::vector<std::string> texts_or_empty(const Table& table, std::string_view name);

}  // namespace cloud
}  // namespace bole
