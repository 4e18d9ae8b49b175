// The linearised equations of a GNSS track.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace bole::survey {

inline constexpr int track_unknowns = 8;  // turn, easting, northing, height, offset of the clocks, lever arm
using TrackVector = Eigen::Matrix<double, track_unknowns, 1>;
using TrackMatrix = Eigen::Matrix<double, track_unknowns, track_unknowns>;

// One fix: what is left of easting, northing and height, and how it changes with the unknowns.
struct TrackRow {
  double time_s = 0;
  Eigen::Vector3d residual = Eigen::Vector3d::Zero();
  Eigen::Matrix<double, 3, track_unknowns> jacobian = Eigen::Matrix<double, 3, track_unknowns>::Zero();
  bool has_height = false;
  bool used = true;  // false: a gross error
  double sd_m = 1;   // beside other fixes
};

inline constexpr double track_height_factor = 2;  // heights of GNSS scatter more than the plan

}  // namespace bole::survey
