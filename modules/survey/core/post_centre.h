// The axis of a post from returns of the side that was seen.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace bole::survey {

struct PostFit {
  bool valid = false;  // round: at least a third of the circle seen, residual below a third of the radius
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  double radius_m = 0;
  double residual_m = 0;  // robust scatter about the circle
};

// Circle through points in plan (levelled): geometric least squares with Tukey weights, started from Kasa's algebraic
// circle. Returns of a post seen from one side have their mean half a radius or more before its axis; the circle does
// not. `weights` (one per point) may be empty.
PostFit fit_post(const std::vector<Eigen::Vector2d>& points, const std::vector<double>& weights, double max_radius_m);

}  // namespace bole::survey
