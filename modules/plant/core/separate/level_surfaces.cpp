#include "plant/core/separate/level_surfaces.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

#include "base/random.h"

namespace bole::plant {
namespace {

constexpr int surface_tries = 600;
constexpr std::size_t sample_size = 8000;  // points that a try is scored with

FoundPlane refined(const Points3& points, FoundPlane plane, double tolerance) {
  for (int round = 0; round < 4; ++round) {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    Eigen::Matrix3d square = Eigen::Matrix3d::Zero();
    double count = 0, residuals = 0;
    for (const auto& p : points) {
      const double d = plane.normal.dot(p) - plane.offset;
      if (std::abs(d) > tolerance) continue;
      mean += p;
      count += 1;
      residuals += d * d;
    }
    if (count < 3) return plane;
    mean /= count;
    for (const auto& p : points)
      if (std::abs(plane.normal.dot(p) - plane.offset) <= tolerance) square += (p - mean) * (p - mean).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(square);
    Eigen::Vector3d normal = solver.eigenvectors().col(0);
    if (normal.dot(plane.normal) < 0) normal = -normal;
    plane.share = count / static_cast<double>(points.size());
    plane.sigma = std::sqrt(residuals / count);
    plane.normal = normal;
    plane.offset = normal.dot(mean);
  }
  return plane;
}

}  // namespace

std::optional<FoundPlane> largest_plane(const Points3& points, double tolerance, double min_share,
                                        const std::optional<Eigen::Vector3d>& near, double max_angle_rad,
                                        const Run& run) {
  if (points.size() < 10) return std::nullopt;
  Random random(29, points.size());
  Points3 sample;
  if (points.size() <= sample_size) {
    sample = points;
  } else {
    for (std::size_t i = 0; i < sample_size; ++i) sample.push_back(points[random.next() % points.size()]);
  }
  FoundPlane best;
  std::size_t best_count = 0;
  const double min_cosine = std::cos(max_angle_rad);
  for (int i = 0; i < surface_tries; ++i) {
    if (i % 50 == 0) run.check_cancel();
    const auto& a = sample[random.next() % sample.size()];
    const auto& b = sample[random.next() % sample.size()];
    const auto& c = sample[random.next() % sample.size()];
    const Eigen::Vector3d cross = (b - a).cross(c - a);
    if (!(cross.norm() > 100 * tolerance * tolerance)) continue;
    Eigen::Vector3d normal = cross.normalized();
    if (near) {
      if (normal.dot(*near) < 0) normal = -normal;
      if (normal.dot(*near) < min_cosine) continue;
    }
    const double offset = normal.dot(a);
    const auto count = static_cast<std::size_t>(
        std::ranges::count_if(sample, [&](const auto& p) { return std::abs(normal.dot(p) - offset) <= tolerance; }));
    if (count <= best_count) continue;
    best_count = count;
    best.normal = normal;
    best.offset = offset;
  }
  if (best_count < 3) return std::nullopt;
  best = refined(points, best, tolerance);
  if (best.share < min_share) return std::nullopt;
  return best;
}

std::vector<Layer> level_layers(const Points3& level, double bin, double plan_cell) {
  if (level.empty()) return {};
  std::unordered_map<int, std::unordered_set<std::uint64_t>> cells;
  const auto part = [&](double v) {
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(std::floor(v / plan_cell)));
  };
  for (const auto& p : level) {
    const auto key = static_cast<std::uint64_t>(part(p.x())) << 32 | part(p.y());
    const int layer = static_cast<int>(std::floor(p.z() / bin));
    // Overlapping layers of two bins, so that a plane on the border of two bins is not halved.
    cells[layer].insert(key);
    cells[layer - 1].insert(key);
  }
  std::vector<std::pair<int, double>> areas;
  for (const auto& [layer, set] : cells)
    areas.emplace_back(layer, static_cast<double>(set.size()) * plan_cell * plan_cell);
  std::ranges::sort(areas);
  const auto area_at = [&](int layer) {
    const auto it = std::ranges::lower_bound(areas, layer, {}, &std::pair<int, double>::first);
    return it != areas.end() && it->first == layer ? it->second : 0.0;
  };
  std::vector<Layer> layers;
  for (const auto& [layer, area] : areas) {
    const double around = std::max({area_at(layer - 4), area_at(layer + 4)});
    bool peak = area > 1.5 * around;
    for (int d = -3; d <= 3; ++d) peak = peak && (area_at(layer + d) < area || (area_at(layer + d) == area && d >= 0));
    if (peak) layers.push_back({(layer + 1) * bin, area});
  }
  return layers;
}

double scene_size(const Points3& points) {
  if (points.empty()) return 0;
  Eigen::Vector3d size;
  std::vector<double> values(points.size());
  for (int axis = 0; axis < 3; ++axis) {
    for (std::size_t i = 0; i < points.size(); ++i) values[i] = points[i][axis];
    const auto quantile = [&](double q) {
      const auto at = values.begin() + static_cast<std::ptrdiff_t>(q * static_cast<double>(values.size() - 1));
      std::ranges::nth_element(values, at);
      return *at;
    };
    const double low = quantile(0.02);
    size[axis] = quantile(0.98) - low;
  }
  return size.norm();
}

}  // namespace bole::plant
