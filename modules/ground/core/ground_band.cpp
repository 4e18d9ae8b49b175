#include "ground/core/ground_band.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/statistics.h"
#include "ground/core/local_plane.h"

namespace bole::ground {
namespace {

constexpr double min_sigma_m = 0.005;

// The lowest peak of the smoothed histogram that is at least half as high as the highest.
double lowest_strong_peak(std::span<const BandPoint> points, double half_band_m) {
  constexpr int bins = 60;
  constexpr std::array<double, 5> kernel{1, 2, 3, 2, 1};
  std::array<double, bins + 4> counts{};
  const double width = 2 * half_band_m / bins;
  for (const auto& p : points)
    counts[static_cast<std::size_t>(
               std::clamp(static_cast<int>((static_cast<double>(p.height) + half_band_m) / width), 0, bins - 1)) +
           2] += 1;
  std::array<double, bins> smooth{};
  for (std::size_t b = 0; b < bins; ++b)
    for (std::size_t k = 0; k < kernel.size(); ++k) smooth[b] += kernel[k] * counts[b + k];
  const double highest = *std::max_element(smooth.begin(), smooth.end());
  std::size_t peak = 0;
  while (smooth[peak] < 0.5 * highest) ++peak;
  while (peak + 1 < bins && smooth[peak + 1] >= smooth[peak]) ++peak;
  return (static_cast<double>(peak) + 0.5) * width - half_band_m;
}

// Scale from the points below the surface `plane` (1.4826 median |residual|), which grass does not reach.
double scale_from_below(std::span<const BandPoint> points, const Eigen::Vector3d& plane, double most) {
  std::vector<double> below(points.size());
  std::size_t n = 0;
  for (const auto& p : points) {
    const double r = static_cast<double>(p.height) -
                     plane.dot(Eigen::Vector3d(1, static_cast<double>(p.dx), static_cast<double>(p.dy)));
    below[n] = -r;
    n += r <= 0 && r > -most;
  }
  below.resize(n);
  return below.empty() ? min_sigma_m : std::clamp(1.4826 * upper_median(below), min_sigma_m, most / 3);
}

}  // namespace

BandFit fit_ground_band(std::span<const BandPoint> points, double half_band_m) {
  if (points.size() < 6) {
    std::vector<double> heights;
    for (const auto& p : points) heights.push_back(static_cast<double>(p.height));
    return {upper_median(heights), 0};
  }
  Eigen::Vector3d plane(lowest_strong_peak(points, half_band_m), 0, 0);
  double sigma = scale_from_below(points, plane, half_band_m);
  constexpr int iterations = 6;
  for (int k = 0; k < iterations; ++k) {
    const double cut = 3.0 * sigma;  // wider than the usual 4.685 would let grass in
    PlaneFit fit;
    double spread = 0;
    for (const auto& p : points) {
      const double dx = static_cast<double>(p.dx), dy = static_cast<double>(p.dy), z = static_cast<double>(p.height);
      const double r = (z - plane(0) - plane(1) * dx - plane(2) * dy) / cut;
      if (std::abs(r) >= 1) continue;
      const double w = (1 - r * r) * (1 - r * r);
      fit.add(dx, dy, z, w);
      spread += w * (dx * dx + dy * dy);
    }
    if (fit.weight() < 1) break;
    const Eigen::Vector3d next = fit.solve(0.02 * spread + 1e-9);
    const bool settled = std::abs(next(0) - plane(0)) < 1e-4;
    plane = next;
    if (k < 2) sigma = scale_from_below(points, plane, half_band_m);
    if (settled && k >= 2) break;
  }
  return {plane(0), sigma};
}

}  // namespace bole::ground
