// Rigid motions. Names read target_source: p_map = T_map_sensor * p_sensor.
#pragma once

#include <Eigen/Geometry>

namespace bole {
inline namespace base {

using Pose = Eigen::Isometry3d;
using Vector6d = Eigen::Matrix<double, 6, 1>;

// Cross-product matrix [v]x.
Eigen::Matrix3d skew(const Eigen::Vector3d& v);

// Rotation vector (rad) <-> rotation.
Eigen::Quaterniond so3_exp(const Eigen::Vector3d& rotation_vector_rad);
Eigen::Vector3d so3_log(const Eigen::Quaterniond& q);

// Twist (rotation rad, translation m) <-> rigid motion, with the left Jacobian (SE(3) exponential).
Pose se3_exp(const Vector6d& twist);
Vector6d se3_log(const Pose& T);

// Motion between two poses at s in [0, 1]: slerp of rotation, linear in translation. Extrapolates outside [0, 1].
Pose interpolate(const Pose& a, const Pose& b, double s);

// roll about x, pitch about y, yaw about z: Rz(yaw) Ry(pitch) Rx(roll) (SPEC B1, E2).
Eigen::Matrix3d rotation_from_rpy(double roll_rad, double pitch_rad, double yaw_rad);

// The rotation of least angle that takes the direction `from` to the direction `to`.
Eigen::Matrix3d rotation_between(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

}  // namespace base
}  // namespace bole
