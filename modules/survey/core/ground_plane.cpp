#include "survey/core/ground_plane.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "base/statistics.h"
#include "cloud/robust_mean.h"

namespace bole::survey {
namespace {

// z = a + b x + c y by iteratively reweighted least squares (Tukey), weights zero beyond 4.685 sigma.
Eigen::Vector3d robust_plane(const std::vector<Eigen::Vector3d>& points, double min_sigma_m) {
  Eigen::Vector3d plane(0, 0, 0);
  std::vector<double> weights(points.size(), 1.0);
  constexpr int iterations = 30;
  for (int it = 0; it < iterations; ++it) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Identity() * 1e-9;
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector3d row(1, points[i].x(), points[i].y());
      normal += weights[i] * row * row.transpose(), right += weights[i] * points[i].z() * row;
    }
    const Eigen::Vector3d next = normal.ldlt().solve(right);
    const bool settled = it > 0 && (next - plane).norm() < 1e-7;
    plane = next;
    if (settled) break;
    std::vector<double> off;
    for (const auto& p : points) off.push_back(std::abs(p.z() - plane.dot(Eigen::Vector3d(1, p.x(), p.y()))));
    const double cut = 4.685 * std::max(min_sigma_m, 1.4826 * upper_median(std::vector(off)));
    for (std::size_t i = 0; i < points.size(); ++i)
      weights[i] = off[i] >= cut ? 0.0 : std::pow(1 - off[i] * off[i] / (cut * cut), 2);
  }
  return plane;
}

// The lowest point of each cell, a tenth of the cell's points being passed over as possible noise.
std::vector<Eigen::Vector3d> lowest_per_cell(const std::vector<Eigen::Vector3d>& points, double cell_m) {
  std::map<std::pair<int, int>, std::vector<Eigen::Vector3d>> cells;
  for (const auto& p : points)
    cells[{static_cast<int>(std::floor(p.y() / cell_m)), static_cast<int>(std::floor(p.x() / cell_m))}].push_back(p);
  std::vector<Eigen::Vector3d> out;
  for (auto& [key, members] : cells) {
    const auto rank = static_cast<std::ptrdiff_t>(std::min<std::size_t>(members.size() / 10, 10));
    std::nth_element(members.begin(), members.begin() + rank, members.end(),
                     [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return a.z() < b.z(); });
    out.push_back(members[static_cast<std::size_t>(rank)]);
  }
  return out;
}

}  // namespace

GroundPlane lowest_plane(const PointCloud& cloud, const Run& run) {
  constexpr double cell_m = 1.0, reach_m = 15.0;
  constexpr std::size_t max_points = 4'000'000, min_cells = 10;
  const std::size_t stride = (cloud.size() + max_points - 1) / max_points;
  std::vector<double> xs, ys;
  std::vector<Eigen::Vector3d> points;
  for (std::size_t i = 0; i < cloud.size(); i += stride)
    if (const auto& p = cloud.positions()[i]; p.allFinite())
      points.push_back(p.cast<double>()), xs.push_back(points.back().x()), ys.push_back(points.back().y());
  run.check_cancel();
  GroundPlane out;
  if (points.empty()) return out;
  const Eigen::Vector2d middle(upper_median(std::move(xs)), upper_median(std::move(ys)));
  std::erase_if(points,
                [&](const Eigen::Vector3d& p) { return (p.head<2>() - middle).cwiseAbs().maxCoeff() > reach_m; });
  const auto low = lowest_per_cell(points, cell_m);
  run.check_cancel();
  if (low.size() < min_cells) return out;
  const Eigen::Vector3d plane = robust_plane(low, 0.05);
  out.normal = Eigen::Vector3d(-plane.y(), -plane.z(), 1).normalized();
  out.valid = true;
  return out;
}

std::optional<double> ground_height_at(const PointCloud& cloud, const Eigen::Matrix3d& R_level_map,
                                       const Eigen::Vector2d& place, double radius_m, const Run& run) {
  std::vector<Eigen::Vector3d> near;  // plan offsets from the place, levelled z
  const Eigen::Vector3d levelled_origin = R_level_map * cloud.origin;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (i % (1 << 20) == 0) run.check_cancel();
    const Eigen::Vector3d p = levelled_origin + R_level_map * cloud.positions()[i].cast<double>();
    const Eigen::Vector2d d = p.head<2>() - place;
    if (d.squaredNorm() < radius_m * radius_m) near.emplace_back(d.x(), d.y(), p.z());  // false for NaN
  }
  constexpr int bins = 30;
  constexpr double cell_m = 0.2, band_m = 0.15, bin_m = 2 * band_m / bins;
  if (near.size() < 20) return std::nullopt;
  const auto low = lowest_per_cell(near, cell_m);
  if (low.size() < 6) return std::nullopt;
  const Eigen::Vector3d plane = robust_plane(low, 0.03);
  // The plane runs along the lower side of a band some centimetres thick; its densest layer is the ground.
  std::array<double, static_cast<std::size_t>(bins)> counts{};
  for (const auto& p : near) {
    const double h = p.z() - plane.dot(Eigen::Vector3d(1, p.x(), p.y()));
    if (std::abs(h) < band_m)
      counts[static_cast<std::size_t>(std::clamp(static_cast<int>((h + band_m) / bin_m), 0, bins - 1))] += 1;
  }
  const auto peak = std::max_element(counts.begin() + 1, counts.end() - 1) - counts.begin();
  double offset = -band_m + (static_cast<double>(peak) + 0.5) * bin_m;
  for (int it = 0; it < 10; ++it) {
    double sum = 0, count = 0;
    for (const auto& p : near) {
      const double h = p.z() - plane.dot(Eigen::Vector3d(1, p.x(), p.y()));
      if (std::abs(h - offset) < 0.05) sum += h, count += 1;
    }
    if (count > 0) offset = sum / count;
  }
  return plane(0) + offset;
}

}  // namespace bole::survey
