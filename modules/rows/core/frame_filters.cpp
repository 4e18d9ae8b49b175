#include "rows/core/frame_filters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "base/transform.h"

namespace bole::rows {
namespace {

constexpr double deg = std::numbers::pi / 180;
using Cell = std::array<std::int64_t, 3>;

Cell cell_of(const Eigen::Vector3d& p, double size) {
  constexpr double most = 1e15;  // beyond, neighbouring cells cannot be told apart anyway
  Cell c{};
  for (int i = 0; i < 3; ++i)
    c[static_cast<std::size_t>(i)] = static_cast<std::int64_t>(std::clamp(std::floor(p[i] / size), -most, most));
  return c;
}

std::map<Cell, std::vector<std::uint32_t>> cells_of(const PointCloud& cloud, double size) {
  std::map<Cell, std::vector<std::uint32_t>> cells;
  for (std::uint32_t i = 0; i < cloud.size(); ++i)
    if (const Eigen::Vector3d p = cloud.position(i); p.allFinite()) cells[cell_of(p, size)].push_back(i);
  return cells;
}

}  // namespace

PointCloud level(const PointCloud& frame, const LevelOptions& o) {
  const Eigen::Matrix3d R = rotation_from_rpy(o.roll_deg * deg, o.pitch_deg * deg, o.yaw_deg * deg);
  PointCloud::Positions positions;
  positions.reserve(frame.size());
  for (std::size_t i = 0; i < frame.size(); ++i) positions.push_back((R * frame.position(i)).cast<float>());
  PointCloud levelled = frame;
  levelled.origin.setZero();
  levelled.set_positions(std::move(positions));
  return levelled;
}

PointCloud cut_region(const PointCloud& frame, const RegionOptions& o) {
  std::vector<std::uint32_t> kept;
  for (std::uint32_t i = 0; i < frame.size(); ++i) {
    const Eigen::Vector3d p = frame.position(i);
    if (p.x() > o.x_min && p.x() < o.x_max && p.y() > o.y_min && p.y() < o.y_max && p.z() > o.z_min && p.z() < o.z_max)
      kept.push_back(i);
  }
  return frame.subset(kept);
}

PointCloud voxel_centroids(const PointCloud& frame, const VoxelOptions& o) {
  PointCloud::Positions centroids;
  for (const auto& [cell, points] : cells_of(frame, o.size)) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const auto i : points) sum += frame.position(i) - frame.origin;
    centroids.push_back((sum / static_cast<double>(points.size())).cast<float>());
  }
  PointCloud out(std::move(centroids), frame.origin);
  out.axes = frame.axes, out.crs_wkt = frame.crs_wkt;
  return out;
}

PointCloud remove_ground(const PointCloud& frame, const RayGroundOptions& o, const Run& run) {
  struct Ray {
    double range_m, height_m;  // above the ground below the sensor
    std::uint32_t index;
  };
  std::map<std::int64_t, std::vector<Ray>> sectors;
  for (std::uint32_t i = 0; i < frame.size(); ++i) {
    const Eigen::Vector3d p = frame.position(i);
    if (p.allFinite())
      sectors[static_cast<std::int64_t>(std::floor(std::atan2(p.y(), p.x()) / (o.sector_deg * deg)))].push_back(
          {p.head<2>().norm(), p.z() + o.sensor_height, i});
  }
  const double local = std::tan(o.local_max_slope_deg * deg), general = std::tan(o.general_max_slope_deg * deg);
  std::vector<std::uint32_t> kept;
  for (auto& [sector, rays] : sectors) {
    run.check_cancel();
    std::stable_sort(rays.begin(), rays.end(), [](const Ray& a, const Ray& b) { return a.range_m < b.range_m; });
    double range = 0, height = 0;  // of the last ground point
    for (const auto& ray : rays) {
      const double step = ray.range_m - range;
      const bool near_last = std::abs(ray.height_m - height) <= std::max(o.height_threshold, local * step);
      const bool near_general = std::abs(ray.height_m) <= std::max(o.height_threshold, general * ray.range_m);
      // After a jump the last ground point says little; the general slope still holds.
      const bool ground = near_last ? near_general : near_general && step > o.reset_distance;
      if (ground)
        range = ray.range_m, height = ray.height_m;
      else
        kept.push_back(ray.index);
    }
  }
  std::sort(kept.begin(), kept.end());
  return frame.subset(kept);
}

PointCloud radius_filter(const PointCloud& frame, const RadiusOptions& o, const Run& run) {
  const auto cells = cells_of(frame, o.radius);
  std::vector<std::uint32_t> kept;
  for (const auto& [cell, points] : cells) {
    run.check_cancel();
    std::vector<std::uint32_t> around;
    for (int dx = -1; dx <= 1; ++dx)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dz = -1; dz <= 1; ++dz)
          if (const auto it = cells.find({cell[0] + dx, cell[1] + dy, cell[2] + dz}); it != cells.end())
            around.insert(around.end(), it->second.begin(), it->second.end());
    for (const auto i : points) {
      int neighbours = -1;  // itself
      for (const auto j : around) {
        neighbours += (frame.position(i) - frame.position(j)).norm() <= o.radius;
        if (neighbours >= o.neighbours_min) break;
      }
      if (neighbours >= o.neighbours_min) kept.push_back(i);
    }
  }
  std::sort(kept.begin(), kept.end());
  return frame.subset(kept);
}

}  // namespace bole::rows
