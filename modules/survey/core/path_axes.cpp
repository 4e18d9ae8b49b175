#include "survey/core/path_axes.h"

#include <Eigen/Geometry>
#include <cmath>

#include "cloud/core/global_frame.h"

namespace bole::survey {
namespace {

constexpr double far_m = 1000;

Eigen::AlignedBox2d plan_of(const PointCloud& cloud) {
  Eigen::AlignedBox2d box;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    if (const Eigen::Vector3d p = cloud.position(i); p.allFinite()) box.extend(Eigen::Vector2d(p.head<2>()));
  return box;
}

Eigen::AlignedBox2d plan_of(const Trajectory& path) {
  Eigen::AlignedBox2d box;
  for (const auto& pose : path.poses) box.extend(Eigen::Vector2d(pose.T_target_sensor.translation().head<2>()));
  return box;
}

bool is_far(const Eigen::AlignedBox2d& points, const Trajectory& path) {
  const auto box = plan_of(path);
  return !points.isEmpty() && !box.isEmpty() && points.exteriorDistance(box) > far_m;
}

// The frame scales the plan a little: rotations are those of the matrix that is nearest to it.
Trajectory to_global(const Trajectory& local, const GlobalFrame& frame) {
  Eigen::Affine3d all = Eigen::Affine3d::Identity();
  all.linear() = frame.A_global_local;
  const Eigen::Matrix3d R_global_local = all.rotation();
  Trajectory out = local;
  for (auto& pose : out.poses) {
    auto& T = pose.T_target_sensor;
    T.translation() = frame.to_global(T.translation());
    T.linear() = R_global_local * T.linear();
  }
  return out;
}

}  // namespace

Trajectory in_axes_of(const PointCloud& points, const Trajectory& path, Report& report) {
  const auto box = plan_of(points);
  if (!is_far(box, path)) return path;
  const auto frame = local_axes_of(points);
  if (!frame) return path;
  auto moved = to_global(path, *frame);
  if (is_far(box, moved)) return path;
  report.find(Severity::note, "path_moved",
              "the path is in the axes of the plot that the cloud was moved from: it was moved with them");
  return moved;
}

}  // namespace bole::survey
