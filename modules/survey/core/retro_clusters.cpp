#include "survey/core/retro_clusters.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "base/statistics.h"
#include "cloud/robust_mean.h"
#include "cloud/voxels.h"

namespace bole::survey {
namespace {

constexpr double link_cell_m = 0.1;  // points of touching cells belong together: gaps of 0.1 to 0.2 m are bridged
constexpr double view_cell_m = 1.0;
constexpr double max_blur_m = 0.5;  // larger groups of small glimpses are things that move: a reflective jacket
constexpr std::size_t max_strong_points = 20'000'000;

struct SensorPositions {
  const std::vector<float>*x = nullptr, *y = nullptr, *z = nullptr;

  explicit SensorPositions(const PointCloud& cloud) {
    if (!cloud.has(arrays::sensor_x) || !cloud.has(arrays::sensor_y) || !cloud.has(arrays::sensor_z)) return;
    x = &cloud.values<float>(arrays::sensor_x), y = &cloud.values<float>(arrays::sensor_y),
    z = &cloud.values<float>(arrays::sensor_z);
  }
  bool known() const { return x != nullptr; }
  Eigen::Vector3d of(std::size_t i) const {
    return {static_cast<double>((*x)[i]), static_cast<double>((*y)[i]), static_cast<double>((*z)[i])};
  }
};

std::vector<std::uint32_t> strong_points(const PointCloud& cloud, double min_intensity, const Run& run) {
  const auto& column = cloud.column(arrays::intensity.name);
  std::vector<std::uint32_t> out;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (i % (1 << 20) == 0) run.check_cancel();
    if (column_value(column, i) > min_intensity && cloud.positions()[i].allFinite())
      out.push_back(static_cast<std::uint32_t>(i));
  }
  return out;
}

// The members of each connected group.
std::vector<std::vector<std::uint32_t>> group_points(const PointCloud& cloud,
                                                     const std::vector<std::uint32_t>& points) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> keyed;
  keyed.reserve(points.size());
  for (const auto i : points) keyed.emplace_back(voxel_key(cloud.positions()[i].cast<double>(), link_cell_m), i);
  std::sort(keyed.begin(), keyed.end());
  std::vector<std::uint64_t> keys;
  for (const auto& [key, i] : keyed)
    if (keys.empty() || keys.back() != key) keys.push_back(key);
  const auto number = connected_groups(keys);
  std::vector<std::vector<std::uint32_t>> groups;
  std::size_t k = 0;
  for (const auto& [key, i] : keyed) {
    while (keys[k] != key) ++k;
    if (number[k] >= groups.size()) groups.resize(number[k] + 1);
    groups[number[k]].push_back(i);
  }
  return groups;
}

double longest_extent(const PointCloud& cloud, const std::vector<std::uint32_t>& points) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto i : points) mean += cloud.positions()[i].cast<double>();
  mean /= static_cast<double>(points.size());
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (const auto i : points) {
    const Eigen::Vector3d d = cloud.positions()[i].cast<double>() - mean;
    scatter += d * d.transpose();
  }
  const Eigen::Vector3d axis = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(scatter).eigenvectors().col(2);
  std::vector<double> along;
  for (const auto i : points) along.push_back(axis.dot(cloud.positions()[i].cast<double>() - mean));
  std::sort(along.begin(), along.end());
  // Two in a hundred at each end may be mixed pixels.
  const std::size_t cut = along.size() / 50;
  return along[along.size() - 1 - cut] - along[cut];
}

// Median over the positions (cells of the sensor's place, each pass apart) that saw it by at least min_seen points.
double seen_extent(const PointCloud& cloud, const std::vector<std::uint32_t>& points,
                   const std::vector<std::uint64_t>& views, double otherwise) {
  constexpr std::size_t min_seen = 5;
  // Of any type: clouds from elsewhere have columns of this name too.
  const Column* passes = cloud.has(arrays::pass) ? &cloud.column(arrays::pass.name) : nullptr;
  const auto pass_of = [&](std::uint32_t i) {
    const double pass = passes != nullptr ? column_value(*passes, i) : 0.0;
    return std::isfinite(pass) ? pass : 0.0;
  };
  std::map<std::pair<std::uint64_t, double>, std::vector<std::uint32_t>> seen;
  for (std::size_t k = 0; k < points.size(); ++k) seen[{views[k], pass_of(points[k])}].push_back(points[k]);
  std::vector<double> extents;
  for (const auto& [view, members] : seen)
    if (members.size() >= min_seen) extents.push_back(longest_extent(cloud, members));
  return extents.empty() ? otherwise : upper_median(std::move(extents));
}

RetroCluster describe(const PointCloud& cloud, const std::vector<std::uint32_t>& points,
                      const SensorPositions& sensor) {
  RetroCluster out;
  out.points = points.size();
  out.members = points;
  out.extent_m = longest_extent(cloud, points);
  std::map<std::uint64_t, std::pair<Eigen::Vector3d, double>> by_view;  // sum of positions, count
  Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
  std::vector<std::uint64_t> views;
  for (const auto i : points) {
    const Eigen::Vector3d at = sensor.known() ? sensor.of(i) : Eigen::Vector3d(Eigen::Vector3d::Zero());
    low = low.cwiseMin(at), high = high.cwiseMax(at);
    views.push_back(voxel_key(at, view_cell_m));
    ++by_view.try_emplace(views.back(), Eigen::Vector3d(Eigen::Vector3d::Zero()), 0.0).first->second.second;
  }
  out.seen_extent_m = seen_extent(cloud, points, views, out.extent_m);
  out.views = static_cast<int>(by_view.size());
  out.view_span_m = sensor.known() ? (high - low).norm() : std::numeric_limits<double>::quiet_NaN();
  std::vector<Eigen::VectorXd> samples;
  for (std::size_t k = 0; k < points.size(); ++k) {
    samples.emplace_back(cloud.positions()[points[k]].cast<double>());
    out.weights.push_back(1.0 / by_view.at(views[k]).second);
  }
  constexpr double min_sigma_m = 0.02;
  out.centre = cloud.origin + Eigen::Vector3d(robust_mean(samples, out.weights, min_sigma_m).mean);
  return out;
}

std::string why_rejected(const RetroCluster& c, const FrameOptions& o) {
  if (c.points < static_cast<std::size_t>(o.min_target_points))
    return fmt::format("{} points, min_target_points is {}", c.points, o.min_target_points);
  if (c.seen_extent_m > o.target_size)
    return fmt::format("{:.2f} m long, target_size is {:.2f} m", c.seen_extent_m, o.target_size);
  if (c.extent_m > o.target_size + max_blur_m)
    return fmt::format("{:.2f} m long in the map and {:.2f} m as seen from one position: it moves, or the map is bent",
                       c.extent_m, c.seen_extent_m);
  if (c.view_span_m < o.target_views)
    return fmt::format("seen from positions {:.1f} m apart, target_views is {:.1f} m", c.view_span_m, o.target_views);
  return {};
}

}  // namespace

RetroSearch find_retro_clusters(const PointCloud& cloud, const FrameOptions& options, const Run& run) {
  const auto points = strong_points(cloud, options.min_intensity, run);
  RetroSearch out;
  out.strong_points = points.size();
  out.too_many = points.size() > max_strong_points || (points.size() > 1000 && points.size() * 4 > cloud.size());
  if (out.too_many) return out;
  const SensorPositions sensor(cloud);
  for (const auto& group : group_points(cloud, points)) {
    if (group.size() < 3) continue;
    run.check_cancel();
    out.clusters.push_back(describe(cloud, group, sensor));
    out.clusters.back().rejected = why_rejected(out.clusters.back(), options);
  }
  std::stable_sort(out.clusters.begin(), out.clusters.end(), [](const RetroCluster& a, const RetroCluster& b) {
    return a.views != b.views ? a.views > b.views : a.points > b.points;
  });
  return out;
}

}  // namespace bole::survey
