// From the antenna to the point that is steered, and between bearings and yaw (SPEC E2).
#pragma once

#include <Eigen/Core>

namespace bole::geo {

// Attitude of a vehicle: body axes x forward, y left, z up; navigation axes x east, y north, z up.
// R_nav_body = Rz(yaw) Ry(pitch) Rx(roll), so yaw is counted from east to north, positive pitch lowers the bow,
// positive roll lowers the right side.
struct Attitude {
  double roll_rad = 0, pitch_rad = 0, yaw_rad = 0;
  Eigen::Matrix3d R_nav_body() const;
};

// The control point (middle of the rear axle on the ground) from the antenna: p = p' - R [a b h]^T, where
// `lever_arm_body` leads from the control point to the antenna, in body axes.
Eigen::Vector3d control_point(const Eigen::Vector3d& antenna_nav, const Attitude& attitude,
                              const Eigen::Vector3d& lever_arm_body);

// Bearing (clockwise from north) <-> yaw (counter-clockwise from east); results in [0, 2 pi) and (-pi, pi].
double bearing_from_yaw_rad(double yaw_rad);
double yaw_from_bearing_rad(double bearing_rad);

}  // namespace bole::geo
