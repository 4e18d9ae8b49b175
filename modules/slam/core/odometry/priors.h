// The adjustment of SPEC A7: conditions weighted by the covariances of the points that they join.
#pragma once

#include "base/transform.h"

namespace bole::slam {

using Matrix6d = Eigen::Matrix<double, 6, 6>;

struct SensorPrior {
  double range_sigma = 0.02;
  double angle_sigma_rad = 0.001;  // of azimuth and elevation
};

// Covariance of X = d (cos phi cos theta, cos phi sin theta, sin phi), observed as azimuth theta, elevation phi and
// range d: M Sigma M^T with M = dX / d(theta, phi, d). Square metres, sensor axes.
Eigen::Matrix3d point_covariance(const Eigen::Vector3d& point_in_sensor, const SensorPrior& prior);

// Poses enter with the covariance (turn, shift; map axes) of their own adjustment.
struct AdjustmentPriors {
  SensorPrior sensor;
  Matrix6d motion_covariance = Matrix6d::Zero();  // of the motion within the frame that de-skews the points
  // Only for de-skewing: the points of the reference count with the sensor prior and with the pose that placed them.
  bool reference_points = false;
  Matrix6d reference_covariance = Matrix6d::Zero();
  Eigen::Vector3d reference_position = Eigen::Vector3d::Zero();
};

// Variance along `axis` of a point at `lever` from a pose with that covariance (map axes).
double pose_variance(const Eigen::Vector3d& axis, const Eigen::Vector3d& lever, const Matrix6d& covariance);

}  // namespace bole::slam
