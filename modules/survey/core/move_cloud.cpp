#include "survey/core/move_cloud.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "cloud/core/whole/whole_cloud.h"

namespace bole::survey {
namespace {

constexpr std::size_t block = 1 << 16;

void move_sensor_columns(const PointCloud& cloud, const Eigen::Matrix3d& R, const Eigen::Vector3d& shift,
                         PointCloud& out, const Run& run) {
  if (!cloud.has(arrays::sensor_x) || !cloud.has(arrays::sensor_y) || !cloud.has(arrays::sensor_z)) return;
  const auto &x = cloud.values<float>(arrays::sensor_x), &y = cloud.values<float>(arrays::sensor_y),
             &z = cloud.values<float>(arrays::sensor_z);
  std::vector<float> nx(x.size()), ny(x.size()), nz(x.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, x.size(), block), [&](const auto& range) {
    run.check_cancel();
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const Eigen::Vector3f p =
          (R * Eigen::Vector3d(static_cast<double>(x[i]), static_cast<double>(y[i]), static_cast<double>(z[i])) + shift)
              .cast<float>();
      nx[i] = p.x(), ny[i] = p.y(), nz[i] = p.z();
    }
  });
  out.set_column(arrays::sensor_x, std::move(nx));
  out.set_column(arrays::sensor_y, std::move(ny));
  out.set_column(arrays::sensor_z, std::move(nz));
}

}  // namespace

PointCloud move_cloud(const PointCloud& cloud, const Pose& T_new_old, const Eigen::Vector3d& new_origin, Axes axes,
                      const Run& run) {
  PointCloud out = cloud;  // shares everything
  out.axes = axes;
  if (T_new_old.matrix().isApprox(Pose::Identity().matrix(), 1e-12) && new_origin == cloud.origin) return out;
  out.origin = new_origin, out.crs_wkt.clear(), out.scale.setZero();
  forget_whole(out.facts);
  const Eigen::Matrix3d R = T_new_old.linear();
  // new offset = R (origin + offset) + t - new origin
  const Eigen::Vector3d shift = T_new_old * cloud.origin - new_origin;
  const auto& before = cloud.positions();
  PointCloud::Positions after(before.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, before.size(), block), [&](const auto& range) {
    run.check_cancel();
    for (std::size_t i = range.begin(); i < range.end(); ++i)
      after[i] = (R * before[i].cast<double>() + shift).cast<float>();
  });
  out.set_positions(std::move(after));
  move_sensor_columns(cloud, R, shift, out, run);
  return out;
}

Trajectory move_trajectory(const Trajectory& trajectory, const Pose& T_new_old, Axes axes) {
  Trajectory out = trajectory;
  out.axes = axes;
  for (auto& p : out.poses) p.T_target_sensor = T_new_old * p.T_target_sensor;
  return out;
}

}  // namespace bole::survey
