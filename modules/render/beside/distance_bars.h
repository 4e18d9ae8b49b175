// How far a cloud lies from another one: the histogram of its distances.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "render/charts/linked_charts.h"
#include "render/draw/figure.h"

namespace bole::render {

// Metres. Bins of one width beside one another.
struct DistanceBars {
  enum class Of { nearest_point, surface, height };  // distances have no sign, height differences do
  Of of = Of::nearest_point;
  double lo_m = 0, bin_m = 0;                       // where the first bin begins; the width of each
  std::vector<std::size_t> counts;                  // points; empty where none has anything near
  std::size_t compared = 0;                         // points
  std::size_t below = 0, above = 0, unmatched = 0;  // outside of the bins; with nothing within `within_m`
  double within_m = 0;
  double median_m = 0, lo95_m = 0, hi95_m = 0;  // not finite: as far as that no one looked
  // Of a figure that stands alone: what was compared with what. Empty: no heading.
  std::string cloud, from;

  double hi_m() const { return lo_m + bin_m * static_cast<double>(counts.size()); }
};

// Shares of all compared points in percent, median and 95 % marked; what lies outside of the bins is told above them.
Figure distance_histogram(const DistanceBars& bars, const ChartSize& size);

}  // namespace bole::render
