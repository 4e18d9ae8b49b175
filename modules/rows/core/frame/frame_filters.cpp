#include "rows/core/frame/frame_filters.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "base/angles.h"
#include "base/error.h"
#include "base/option.h"
#include "base/transform.h"

namespace bole::rows {
namespace {

using Cell = std::array<std::int64_t, 3>;

Cell cell_of(const Eigen::Vector3d& p, double size) {
  constexpr double limit = 1e15;  // beyond, neighbouring cells cannot be told apart anyway
  Cell c{};
  for (int i = 0; i < 3; ++i)
    c[static_cast<std::size_t>(i)] = static_cast<std::int64_t>(std::clamp(std::floor(p[i] / size), -limit, limit));
  return c;
}

std::map<Cell, std::vector<std::uint32_t>> cells_of(const PointCloud& cloud, double size) {
  std::map<Cell, std::vector<std::uint32_t>> cells;
  for (std::uint32_t i = 0; i < cloud.size(); ++i)
    if (const Eigen::Vector3d p = cloud.position(i); p.allFinite()) cells[cell_of(p, size)].push_back(i);
  return cells;
}

}  // namespace

namespace {

// Attitude at any time of a recording.
class AttitudeTrack {
 public:
  explicit AttitudeTrack(const Table& t)
      : time_(t.numbers("time_s")),
        roll_(t.numbers("roll_deg")),
        pitch_(t.numbers("pitch_deg")),
        yaw_(t.numbers("yaw_deg")) {
    for (std::size_t i = 0; i < time_.size(); ++i)
      if (!std::isfinite(time_[i] + roll_[i] + pitch_[i] + yaw_[i]) || (i > 0 && !(time_[i] > time_[i - 1])))
        throw bad_input("attitude " + std::to_string(i + 1) + " has no number or a time that does not increase",
                        "time_s in increasing order, roll_deg, pitch_deg, yaw_deg");
    if (time_.empty()) throw bad_input("the attitude table is empty", "time_s, roll_deg, pitch_deg, yaw_deg");
  }
  Eigen::Vector3d rpy_deg(double t) const {
    constexpr double slack_s = 0.5;
    if (!(t >= time_.front() - slack_s && t <= time_.back() + slack_s))
      throw bad_input(
          "a point has the time " + number_text(t) + " s",
          "attitudes around it: they run from " + number_text(time_.front()) + " to " + number_text(time_.back()));
    const auto after = std::upper_bound(time_.begin(), time_.end(), t);
    const auto j = static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(after - time_.begin(), 1, std::max<std::ptrdiff_t>(std::ssize(time_) - 1, 1)));
    if (time_.size() == 1) return {roll_[0], pitch_[0], yaw_[0]};
    const double s = std::clamp((t - time_[j - 1]) / (time_[j] - time_[j - 1]), 0.0, 1.0);
    const auto mixed = [&](const std::vector<double>& v) { return v[j - 1] + s * (v[j] - v[j - 1]); };
    const double turn = std::remainder(yaw_[j] - yaw_[j - 1], 360.0);
    return {mixed(roll_), mixed(pitch_), yaw_[j - 1] + s * turn};
  }

 private:
  std::vector<double> time_, roll_, pitch_, yaw_;
};

std::vector<double> times_of(const PointCloud& frame) {
  if (!frame.has("time"))
    throw bad_input("the frame has no column time and attitudes are connected", "a time for every point",
                    "Give roll_deg and pitch_deg instead");
  std::vector<double> times;
  const auto& column = frame.column("time");
  for (std::size_t i = 0; i < frame.size(); ++i) times.push_back(column_value(column, i));
  return times;
}

}  // namespace

PointCloud level(const PointCloud& frame, const LevelOptions& o, const Table* attitude) {
  PointCloud::Positions positions;
  positions.reserve(frame.size());
  Eigen::Matrix3d R = rotation_from_rpy(o.roll_deg * rad_per_deg, o.pitch_deg * rad_per_deg, o.yaw_deg * rad_per_deg);
  if (attitude == nullptr) {
    for (std::size_t i = 0; i < frame.size(); ++i) positions.push_back((R * frame.position(i)).cast<float>());
  } else {
    constexpr double step_s = 0.0005;  // one rotation serves so long
    const AttitudeTrack track(*attitude);
    const auto times = times_of(frame);
    double done = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t i = 0; i < frame.size(); ++i) {
      if (!(std::abs(times[i] - done) <= step_s / 2)) {
        done = times[i];
        const Eigen::Vector3d a =
            rad_per_deg * (track.rpy_deg(done) + Eigen::Vector3d(o.roll_deg, o.pitch_deg, o.yaw_deg));
        R = rotation_from_rpy(a[0], a[1], a[2]);
      }
      positions.push_back((R * frame.position(i)).cast<float>());
    }
  }
  PointCloud levelled = frame;
  levelled.origin.setZero();
  levelled.set_positions(std::move(positions));
  return levelled;
}

PointCloud cut_region(const PointCloud& frame, const RegionOptions& o) {
  std::vector<std::uint32_t> kept;
  for (std::uint32_t i = 0; i < frame.size(); ++i) {
    const Eigen::Vector3d p = frame.position(i);
    if (p.x() > o.min_x && p.x() < o.max_x && p.y() > o.min_y && p.y() < o.max_y && p.z() > o.min_z && p.z() < o.max_z)
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
  out.axes = frame.axes;
  out.crs_wkt = frame.crs_wkt;
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
      sectors[static_cast<std::int64_t>(std::floor(std::atan2(p.y(), p.x()) / (o.sector_deg * rad_per_deg)))].push_back(
          {p.head<2>().norm(), p.z() + o.sensor_height, i});
  }
  const double local = std::tan(o.max_local_slope_deg * rad_per_deg),
               general = std::tan(o.max_general_slope_deg * rad_per_deg);
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
      if (ground) {
        range = ray.range_m;
        height = ray.height_m;
      } else {
        kept.push_back(ray.index);
      }
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
        if (neighbours >= o.min_neighbours) break;
      }
      if (neighbours >= o.min_neighbours) kept.push_back(i);
    }
  }
  std::sort(kept.begin(), kept.end());
  return frame.subset(kept);
}

}  // namespace bole::rows
