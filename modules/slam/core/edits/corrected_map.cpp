#include "slam/core/edits/corrected_map.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <array>
#include <limits>

namespace bole::slam {
namespace {

constexpr std::size_t block = 1 << 16;

}  // namespace

Trajectory corrected(const Trajectory& trajectory, const Corrections& corrections) {
  Trajectory out = trajectory;
  for (auto& p : out.poses) p.T_target_sensor = corrections.at(p.time_s) * p.T_target_sensor;
  return out;
}

PointCloud corrected(const PointCloud& points, const Corrections& corrections, const Run& run) {
  PointCloud out = points;  // shares everything
  if (points.empty()) return out;
  const auto& time = points.values<double>(arrays::time);
  const bool rays = points.has(arrays::sensor_x) && points.has(arrays::sensor_y) && points.has(arrays::sensor_z);
  const auto& before = points.positions();
  PointCloud::Positions after(before.size());
  std::array<std::vector<float>, 3> sensor;
  std::array<const std::vector<float>*, 3> sensor_before{};
  if (rays) {
    sensor_before = {&points.values<float>(arrays::sensor_x), &points.values<float>(arrays::sensor_y),
                     &points.values<float>(arrays::sensor_z)};
    for (auto& column : sensor) column.resize(before.size());
  }
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, before.size(), block), [&](const auto& range) {
    run.check_cancel();
    double last_s = std::numeric_limits<double>::quiet_NaN();
    Pose T = Pose::Identity();
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      if (time[i] != last_s) {
        last_s = time[i];
        // Offsets are relative to the origin of the cloud, which stays.
        const Pose C = corrections.at(last_s);
        T.linear() = C.linear();
        T.translation() = C * points.origin - points.origin;
      }
      after[i] = (T * before[i].cast<double>()).cast<float>();
      if (!rays) continue;
      const Eigen::Vector3f at((*sensor_before[0])[i], (*sensor_before[1])[i], (*sensor_before[2])[i]);
      const Eigen::Vector3f moved = (T * at.cast<double>()).cast<float>();
      for (std::size_t k = 0; k < 3; ++k) sensor[k][i] = moved[static_cast<Eigen::Index>(k)];
    }
  });
  out.set_positions(std::move(after));
  if (rays) {
    out.set_column(arrays::sensor_x, std::move(sensor[0]));
    out.set_column(arrays::sensor_y, std::move(sensor[1]));
    out.set_column(arrays::sensor_z, std::move(sensor[2]));
  }
  return out;
}

}  // namespace bole::slam
