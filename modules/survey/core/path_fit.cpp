#include "survey/core/path_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bole::survey {
namespace {

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, at);
  return *at;
}

}  // namespace

PathSample::PathSample(const PointCloud& points) {
  constexpr std::size_t wanted = 4000;
  const auto& time = points.values<double>(arrays::time);
  const std::size_t step = std::max<std::size_t>(1, points.size() / wanted);
  for (std::size_t i = 0; i < points.size(); i += step) {
    if (!std::isfinite(time[i])) continue;
    places_.push_back(points.position(i));
    times_.push_back(time[i]);
  }
  if (times_.empty()) throw bad_input("no point has a time", "the time of every point", "Export the cloud with times");
  constexpr double stray = 0.002;
  span_ = {quantile(times_, stray), quantile(times_, 1 - stray)};
}

double PathSample::share_with_pose(const PathCurve& curve, double offset_s) const {
  const auto with = std::ranges::count_if(times_, [&](double t) { return curve.at(t - offset_s).has_value(); });
  return static_cast<double>(with) / static_cast<double>(times_.size());
}

// With the time of the point that stands `step` behind in the sample.
double PathSample::median_distance(const PathCurve& curve, double offset_s, std::size_t step) const {
  std::vector<double> distances;
  for (std::size_t i = 0; i < times_.size(); ++i)
    if (const auto place = curve.at(times_[(i + step) % times_.size()] - offset_s))
      distances.push_back((places_[i] - *place).norm());
  return quantile(std::move(distances), 0.5);
}

PathSample::Fit PathSample::fit(const PathCurve& curve, double offset_s) const {
  std::vector<double> distances;
  std::vector<Eigen::Vector3d> sensors;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < times_.size(); ++i)
    if (const auto place = curve.at(times_[i] - offset_s)) {
      distances.push_back((places_[i] - *place).norm());
      sensors.push_back(*place);
      mean += *place;
    }
  if (sensors.empty()) return {};
  mean /= static_cast<double>(sensors.size());
  double spread = 0;
  for (const auto& s : sensors) spread += (s - mean).squaredNorm();
  spread = std::sqrt(spread / static_cast<double>(sensors.size()));
  Fit out;
  out.nearest_m = quantile(distances, 0.01);
  out.median_m = quantile(std::move(distances), 0.5);
  // Three pairings with times that have nothing to do with the points; the order of the points may be that of time.
  const std::size_t n = times_.size();
  out.shuffled_m = quantile({median_distance(curve, offset_s, n / 4 + 1), median_distance(curve, offset_s, n / 2 + 1),
                             median_distance(curve, offset_s, 3 * n / 4 + 1)},
                            0.5);
  constexpr double long_enough = 0.3;
  out.judged = spread > long_enough * out.median_m;
  return out;
}

PathSample::Shift PathSample::best_shift(const PathCurve& curve, double offset_s) const {
  constexpr int steps = 60;
  constexpr double covered = 0.5, nearer = 0.9;
  std::vector<double> medians;
  Shift best;
  double none = std::numeric_limits<double>::quiet_NaN();
  for (int k = -steps; k <= steps; ++k) {
    const double shift = shift_step_s * k;
    if (share_with_pose(curve, offset_s + shift) < covered) continue;
    const double median = median_distance(curve, offset_s + shift, 0);
    if (medians.empty() || median < best.median_m) best = {shift, median, false};
    if (k == 0) none = median;
    medians.push_back(median);
  }
  if (medians.empty()) return best;
  // Where it is best without a shift, most shifts must be worse for that to mean something.
  const double usual = quantile(std::move(medians), 0.75);
  best.certain = best.median_m < nearer * (std::abs(best.seconds) <= shift_step_s ? usual : none);
  return best;
}

}  // namespace bole::survey
