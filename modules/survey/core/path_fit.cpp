#include "survey/core/path_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace bole::survey {
namespace {

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, at);
  return *at;
}

}  // namespace

PathSample::PathSample(const PointCloud& points) : points_(points) {
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

PathSample::Lie PathSample::lie(const PathCurve& curve, double offset_s) const {
  std::vector<Eigen::Vector3d> offsets;
  for (std::size_t i = 0; i < times_.size(); ++i)
    if (const auto place = curve.at(times_[i] - offset_s)) offsets.push_back(places_[i] - *place);
  const auto median_of = [&](auto&& value) {
    std::vector<double> values;
    for (const auto& d : offsets) values.push_back(value(d));
    return quantile(std::move(values), 0.5);
  };
  const Eigen::Vector3d middle(median_of([](const auto& d) { return d.x(); }),
                               median_of([](const auto& d) { return d.y(); }), 0);
  return {middle.norm(), median_of([&](const auto& d) { return (d - middle).norm(); }), height_over_lowest(curve)};
}

// Median over the cells of 2 m that the path crosses and that have points.
double PathSample::height_over_lowest(const PathCurve& curve) const {
  constexpr double cell_m = 2, step_s = 1;
  constexpr std::size_t enough_points = 2'000'000, max_places = 20'000;
  const auto cell_of = [](const Eigen::Vector3d& p) {
    return std::pair(std::floor(p.x() / cell_m), std::floor(p.y() / cell_m));
  };
  struct Cell {
    double sensor_z, lowest = std::numeric_limits<double>::infinity();
  };
  std::map<std::pair<double, double>, Cell> cells;
  const double length = curve.end_s() - curve.begin_s();
  const double step = std::max(step_s, length / static_cast<double>(max_places));
  for (double t = 0; t <= length; t += step)
    if (const auto place = curve.at(curve.begin_s() + t)) cells.try_emplace(cell_of(*place), Cell{place->z()});
  for (std::size_t i = 0; i < points_.size(); i += 1 + points_.size() / enough_points) {
    const auto p = points_.position(i);
    if (const auto it = cells.find(cell_of(p)); it != cells.end())
      it->second.lowest = std::min(it->second.lowest, p.z());
  }
  std::vector<double> heights;
  for (const auto& [at, cell] : cells)
    if (std::isfinite(cell.lowest)) heights.push_back(cell.sensor_z - cell.lowest);
  return quantile(std::move(heights), 0.5);
}

PathSample::Shift PathSample::best_shift(const PathCurve& curve, double offset_s) const {
  constexpr int steps = 60;
  constexpr double covered = 0.5, nearer = 0.9;
  Shift best{0, std::numeric_limits<double>::infinity(), false};
  const auto consider = [&](double shift) {
    if (share_with_pose(curve, offset_s + shift) < covered) return;
    const double median = median_distance(curve, offset_s + shift, 0);
    if (median < best.median_m) best = {shift, median, false};
  };
  for (int k = -steps; k <= steps; ++k) consider(shift_step_s * k);
  const Shift coarse = best;
  const int fine = static_cast<int>(std::lround(shift_step_s / fine_step_s));
  for (int k = -fine; k <= fine; ++k) consider(coarse.seconds + fine_step_s * k);
  // The median is flat about its least value: parts of a step are only told where they matter.
  constexpr double much_nearer = 0.95;
  if (!(best.median_m < much_nearer * coarse.median_m)) best = coarse;
  best.certain = best.median_m < nearer * median_distance(curve, offset_s, 0);
  return best;
}

}  // namespace bole::survey
