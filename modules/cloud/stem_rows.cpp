#include "cloud/stem_rows.h"

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "cloud/table_columns.h"

namespace bole {
inline namespace cloud {
namespace {

bool is_numeric(const Table& table, std::string_view column) {
  const auto* values = table.find(column);
  return values != nullptr && !std::holds_alternative<std::vector<std::string>>(*values);
}

}  // namespace

std::vector<std::size_t> kept_rows(const Table& stems) {
  const auto* values = stems.find("state");
  const auto* state = values != nullptr ? std::get_if<std::vector<std::string>>(values) : nullptr;
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < stems.rows(); ++i)
    if (state == nullptr || (*state)[i] != "rejected") kept.push_back(i);
  return kept;
}

std::vector<std::size_t> counted_rows(const Table& stems, const CountingRule& rule) {
  const auto x = stems.numbers("x_m"), y = stems.numbers("y_m"), dbh = stems.numbers("dbh_cm");
  std::vector<std::size_t> counted;
  for (const auto i : kept_rows(stems))
    if (std::isfinite(dbh[i]) && rule.counts({x[i], y[i]}, dbh[i])) counted.push_back(i);
  return counted;
}

Table with_counted(Table stems, const CountingRule& rule) {
  for (const char* needed : {"x_m", "y_m", "dbh_cm"})
    if (!is_numeric(stems, needed)) return stems;
  std::vector<std::int64_t> counted(stems.rows(), 0);
  for (const auto row : counted_rows(stems, rule)) counted[row] = 1;
  stems.set("counted", std::move(counted));
  return stems;
}

std::vector<double> known_heights(const Table& stems) {
  auto heights = numbers_or_nan(stems, "height_m");
  const auto bounds = numbers_or_nan(stems, "height_lower_bound_m");
  for (std::size_t i = 0; i < heights.size(); ++i)
    if (!std::isfinite(heights[i])) heights[i] = bounds[i];
  return heights;
}

}  // namespace cloud
}  // namespace bole
