// Height and level of local axes from control heights.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace bole::survey {

struct HeightPair {
  Eigen::Vector3d local = Eigen::Vector3d::Zero();
  double height_m = 0;  // in the height system of the control points
  double sd_m = 0.03;   // of the difference
};

struct HeightFit {
  Eigen::Vector3d centre_local = Eigen::Vector3d::Zero();  // mean of the points, by weight
  double centre_height_m = 0;
  // Rise of the level plane along x and y of the local axes: height = centre_height + (z - centre z) + rise . (x, y).
  Eigen::Vector2d rise = Eigen::Vector2d::Zero();
  Eigen::Matrix2d rise_covariance = Eigen::Matrix2d::Zero();
  double shift_se_m = 0;
  bool levelled = false;  // rise was adjusted, not only the shift
  std::vector<double> residuals_m;
  double chi2 = 0;
  int redundancy = 0;

  double height_of(const Eigen::Vector3d& local) const;
  // The rotation that levels: turns local axes so that its z is the height.
  Eigen::Matrix3d R_level_local() const;
};

// Least squares. The level is adjusted where three or more points do not lie on a line; `known_level_rad` is then how
// well the local axes are known to be level already, as an observation of the rise with the value zero; nothing: the
// level is free. Else only the shift.
HeightFit fit_heights(const std::vector<HeightPair>& pairs, const std::optional<double>& known_level_rad,
                      bool adjust_level);

// Whether three or more of the points span a triangle whose height is at least a tenth of its longest side.
bool spans_a_plane(const std::vector<Eigen::Vector2d>& points);

// The index of the height that the others contradict (by more than one good one in a thousand), -1 for none. Needs four
// heights to name one. The level is free.
int height_blunder(const std::vector<HeightPair>& pairs, bool adjust_level, bool sd_stated);

}  // namespace bole::survey
