// The line a tractor is to follow.
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace bole::steering {

// From `a` in the direction `yaw_rad` (east to north), navigation axes, metres.
struct GuidanceLine {
  Eigen::Vector2d a = Eigen::Vector2d::Zero();
  double yaw_rad = 0;

  Eigen::Vector2d along() const { return {std::cos(yaw_rad), std::sin(yaw_rad)}; }
  Eigen::Vector2d left() const { return {-std::sin(yaw_rad), std::cos(yaw_rad)}; }
  double along_m(const Eigen::Vector2d& p) const { return (p - a).dot(along()); }
  double offset_m(const Eigen::Vector2d& p) const { return (p - a).dot(left()); }  // positive left of the line
};

}  // namespace bole::steering
