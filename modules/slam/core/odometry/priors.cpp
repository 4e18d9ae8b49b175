#include "slam/core/odometry/priors.h"

#include <algorithm>
#include <cmath>

namespace bole::slam {

Eigen::Matrix3d point_covariance(const Eigen::Vector3d& point_in_sensor, const SensorPrior& prior) {
  const double level_m = std::max(point_in_sensor.head<2>().norm(), 1e-9),
               range_m = std::max(point_in_sensor.norm(), 1e-9);
  // theta: azimuth, phi: elevation
  const double cos_theta = point_in_sensor.x() / level_m, sin_theta = point_in_sensor.y() / level_m,
               cos_phi = level_m / range_m, sin_phi = point_in_sensor.z() / range_m;
  Eigen::Matrix3d M;
  M.col(0) << -range_m * cos_phi * sin_theta, range_m * cos_phi * cos_theta, 0;
  M.col(1) << -range_m * sin_phi * cos_theta, -range_m * sin_phi * sin_theta, range_m * cos_phi;
  M.col(2) << cos_phi * cos_theta, cos_phi * sin_theta, sin_phi;
  const double angle2 = prior.angle_sigma_rad * prior.angle_sigma_rad,
               range2 = prior.range_sigma_m * prior.range_sigma_m;
  return M * Eigen::Vector3d(angle2, angle2, range2).asDiagonal() * M.transpose();
}

double pose_variance(const Eigen::Vector3d& axis, const Eigen::Vector3d& lever, const Matrix6d& covariance) {
  Vector6d a;
  a << lever.cross(axis), axis;
  return a.dot(covariance * a);
}

}  // namespace bole::slam
