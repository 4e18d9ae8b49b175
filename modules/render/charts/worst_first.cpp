#include "render/charts/worst_first.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "render/charts/columns.h"

namespace bole::render {

std::vector<std::size_t> worst_first(const Table& stems) {
  const auto dbh = numbers_or_nan(stems, "dbh_cm"), lo = numbers_or_nan(stems, "dbh_lo_cm"),
             hi = numbers_or_nan(stems, "dbh_hi_cm");
  const auto quality = texts_or_empty(stems, "quality");
  const auto rank = [&](std::size_t i) { return quality[i] == "poor" ? 0 : quality[i] == "fair" ? 1 : 2; };
  const auto width = [&](std::size_t i) {
    const double w = (hi[i] - lo[i]) / std::max(dbh[i], 0.1);
    return std::isfinite(w) ? w : std::numeric_limits<double>::infinity();
  };
  std::vector<std::size_t> order(stems.rows());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    return rank(a) != rank(b) ? rank(a) < rank(b) : width(a) > width(b);
  });
  return order;
}

}  // namespace bole::render
