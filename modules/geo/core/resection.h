// Where a sensor stands and where it looks, from marks of known position (SPEC B1).
#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <vector>

namespace bole::geo {

struct RangeToMark {
  Eigen::Vector3d mark_nav = Eigen::Vector3d::Zero();  // known position, metres
  double range_m = 0;                                  // slant range from the sensor
  double sigma_m = 0.02;                               // its standard deviation
};

struct ResectionOptions {
  // About where the sensor stands. Three marks, or any number in one plane, leave two positions, mirrored in their
  // plane; the one nearer to this is taken.
  std::optional<Eigen::Vector3d> near_nav;
  // Known height of the sensor: only x and y are adjusted, which marks at about the sensor's height need.
  std::optional<double> height_m;
  // Largest standard error of the weakest direction that is accepted, metres.
  double max_sigma_m = 0.5;
};

struct Resection {
  Eigen::Vector3d position_nav = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();  // m^2, from the ranges' sigmas; z row zero with a known height
  std::vector<double> residuals_m;                       // measured - adjusted, per mark
  double sigma0 = std::numeric_limits<double>::quiet_NaN();  // of unit weight; NaN without redundancy
  int redundancy = 0;
};

// Solves L_i = |p - p_i| by weighted least squares (the printed eq. 3 lacks the squares). Throws Error{bad_input}, with
// the reason, where the geometry does not carry a position: too few marks, marks on a line, two positions that fit
// alike, the sensor in the plane of the marks, ranges that meet nowhere.
Resection resect(const std::vector<RangeToMark>& ranges, const ResectionOptions& options = {});

// The same direction seen from the levelled sensor and known in navigation axes: for instance from mark F to mark E.
struct DirectionPair {
  Eigen::Vector2d seen = Eigen::Vector2d::Zero();       // in levelled sensor axes, metres
  Eigen::Vector2d known_nav = Eigen::Vector2d::Zero();  // in navigation axes, metres
};

struct Heading {
  double yaw_rad = 0;             // turns levelled sensor axes to navigation axes, in (-pi, pi]
  double se_rad = 0;              // standard error from `sigma_m`
  double worst_residual_rad = 0;  // largest angle between a turned and a known direction
};

// The rotation about z that brings the seen directions onto the known ones in the sense of least squares; long
// directions count more. `sigma_m` is the standard deviation of the end of a direction vector. Throws Error{bad_input}
// without a usable direction, or where the lengths of a pair differ by more than 6 sigma (another mark was taken).
Heading heading_from_directions(const std::vector<DirectionPair>& directions, double sigma_m = 0.03);

}  // namespace bole::geo
