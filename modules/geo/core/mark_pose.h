// Position and heading of a sensor from points of known position that it sees (SPEC B1).
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

namespace bole::geo {

struct SeenMark {
  Eigen::Vector3d mark_nav = Eigen::Vector3d::Zero();  // known position, metres
  Eigen::Vector3d seen = Eigen::Vector3d::Zero();      // in levelled sensor axes, metres
};

// Standard deviations of one observation.
struct MarkErrors {
  double mark_plan_m = 0.01, mark_height_m = 0.02;  // of the known position, per axis
  double range_m = 0.01, direction_rad = 0.001;     // of the sensor
  double tilt_rad = 0.002;                          // of the levelling, per axis, shared by all marks
};

struct MarkPose {
  Eigen::Vector3d position_nav = Eigen::Vector3d::Zero();
  double yaw_rad = 0;  // turns levelled sensor axes to navigation axes
  // Of x, y, z (metres) and yaw (radians), from the standard deviations given.
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();
  std::vector<Eigen::Vector3d> residuals_nav_m;              // known - adjusted, per mark
  double sigma0 = std::numeric_limits<double>::quiet_NaN();  // of unit weight
  int redundancy = 0;
};

// Least squares over all three coordinates of every mark: position, yaw and a small tilt that remains of the levelling.
// Two marks carry it, from three on errors show in sigma0. Throws Error{bad_input} with the reason for fewer than two
// marks, coordinates that are not finite, and marks that carry no heading (all above one another).
MarkPose pose_from_marks(const std::vector<SeenMark>& marks, const MarkErrors& errors);

// The largest sigma0 that errors of the assumed size give in 99.9 % of cases.
double largest_usual_sigma0(int redundancy);

}  // namespace bole::geo
