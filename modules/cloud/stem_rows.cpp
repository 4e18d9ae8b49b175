#include "cloud/stem_rows.h"

#include <cmath>
#include <string>

#include "cloud/table_columns.h"

namespace bole {
inline namespace cloud {

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

std::vector<double> known_heights(const Table& stems) {
  auto heights = numbers_or_nan(stems, "height_m");
  const auto bounds = numbers_or_nan(stems, "height_lower_bound_m");
  for (std::size_t i = 0; i < heights.size(); ++i)
    if (!std::isfinite(heights[i])) heights[i] = bounds[i];
  return heights;
}

}  // namespace cloud
}  // namespace bole
