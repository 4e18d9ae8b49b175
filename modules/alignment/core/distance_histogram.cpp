#include "alignment/core/distance_histogram.h"

#include <algorithm>
#include <cmath>

#include "alignment/core/quantile.h"

namespace bole::alignment {
namespace {

constexpr double shown_share = 0.995;              // of what was found
constexpr double max_bins = 60, min_bin_m = 1e-4;  // a chart of a panel's width; finer than coordinates of files

// 1, 2 or 5 times a power of ten.
double bin_for(double span_m) {
  const double least = std::max(span_m / max_bins, min_bin_m);
  const double power = std::pow(10, std::floor(std::log10(least) + 1e-9));
  for (const double step : {1.0, 2.0, 5.0})
    if (step * power >= least * (1 - 1e-9)) return step * power;
  return 10 * power;
}

std::vector<float> finite_of(const std::vector<float>& values) {
  std::vector<float> found;
  std::ranges::copy_if(values, std::back_inserter(found), [](float v) { return std::isfinite(v); });
  return found;
}

void count(DistanceHistogram& histogram, const std::vector<float>& found, double from_m, double to_m) {
  histogram.bin_m = bin_for(to_m - from_m);
  const double first = std::floor(from_m / histogram.bin_m), last = std::floor(to_m / histogram.bin_m);
  histogram.lo_m = first * histogram.bin_m;
  histogram.counts.assign(static_cast<std::size_t>(last - first) + 1, 0);
  for (const float value : found) {
    const double bin = std::floor(static_cast<double>(value) / histogram.bin_m) - first;
    if (bin < 0)
      ++histogram.below;
    else if (bin >= static_cast<double>(histogram.counts.size()))
      ++histogram.above;
    else
      ++histogram.counts[static_cast<std::size_t>(bin)];
  }
}

}  // namespace

DistanceHistogram histogram_of_distances(const std::vector<float>& distances_m, std::size_t compared) {
  DistanceHistogram histogram;
  auto found = finite_of(distances_m);
  histogram.compared = compared;
  histogram.unmatched = compared - found.size();
  histogram.median_m = quantile(found, compared, 0.5);
  histogram.hi95_m = quantile(found, compared, 0.95);
  if (!found.empty()) count(histogram, found, 0, quantile(found, found.size(), shown_share));
  return histogram;
}

DistanceHistogram histogram_of_rises(const std::vector<float>& rises_m, std::size_t compared) {
  DistanceHistogram histogram;
  auto found = finite_of(rises_m);
  const auto at = [&](double share) { return quantile(found, found.size(), share); };
  histogram.compared = compared;
  histogram.unmatched = compared - found.size();
  histogram.median_m = at(0.5);
  histogram.lo95_m = at(0.025);
  histogram.hi95_m = at(0.975);
  if (!found.empty()) count(histogram, found, at((1 - shown_share) / 2), at((1 + shown_share) / 2));
  return histogram;
}

}  // namespace bole::alignment
