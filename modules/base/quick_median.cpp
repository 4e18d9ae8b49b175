#include "base/quick_median.h"

#include <algorithm>
#include <vector>

#include "base/statistics.h"

namespace bole {
inline namespace base {

double upper_median_near(std::span<double> values, double guess) {
  const double low = 0.65 * guess, high = 1.15 * guess;  // scales of fits shrink from step to step
  std::vector<double> near(values.size());
  std::size_t below = 0, n = 0;
  for (const double v : values) {
    near[n] = v;
    n += v >= low && v < high, below += v < low;
  }
  const std::size_t middle = values.size() / 2;
  if (middle < below || middle >= below + n) return upper_median(values);
  const auto at = near.begin() + static_cast<std::ptrdiff_t>(middle - below);
  std::nth_element(near.begin(), at, near.begin() + static_cast<std::ptrdiff_t>(n));
  return *at;
}

}  // namespace base
}  // namespace bole
