#include "slam/core/odometry/priors.h"

#include <algorithm>
#include <cmath>

namespace bole::slam {

Eigen::Matrix3d point_covariance(const Eigen::Vector3d& point_in_sensor, const SensorPrior& prior) {
  const double level = std::max(point_in_sensor.head<2>().norm(), 1e-9), range = std::max(point_in_sensor.norm(), 1e-9);
  // theta: azimuth, phi: elevation
  const double cos_theta = point_in_sensor.x() / level, sin_theta = point_in_sensor.y() / level,
               cos_phi = level / range, sin_phi = point_in_sensor.z() / range;
  Eigen::Matrix3d M;
  M.col(0) << -range * cos_phi * sin_theta;
  range* cos_phi* cos_theta;
  0;
  M.col(1) << -range * sin_phi * cos_theta;
  -range* sin_phi* sin_theta;
  range* cos_phi;
  M.col(2) << cos_phi * cos_theta;
  cos_phi* sin_theta;
  sin_phi;
  const double angle2 = prior.angle_sigma_rad * prior.angle_sigma_rad, range2 = prior.range_sigma * prior.range_sigma;
  return M * Eigen::Vector3d(angle2, angle2, range2).asDiagonal() * M.transpose();
}

double pose_variance(const Eigen::Vector3d& axis, const Eigen::Vector3d& lever, const Matrix6d& covariance) {
  Vector6d a;
  a << lever.cross(axis);
  axis;
  return a.dot(covariance * a);
}

}  // namespace bole::slam
