#include "alignment/core/quantile.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bole::alignment {

double quantile(std::vector<float>& found, std::size_t all, double share) {
  if (all == 0) return std::numeric_limits<double>::quiet_NaN();
  const auto k = static_cast<std::size_t>(std::max(1.0, std::ceil(share * static_cast<double>(all)))) - 1;
  if (k >= found.size()) return std::numeric_limits<double>::infinity();
  const auto at = found.begin() + static_cast<std::ptrdiff_t>(k);
  std::nth_element(found.begin(), at, found.end());
  return static_cast<double>(*at);
}

}  // namespace bole::alignment
