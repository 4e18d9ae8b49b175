// The area that a survey covers, as its trees show it.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace bole::survey {

// The convex hull of places in the plan.
class StandHull {
 public:
  explicit StandHull(std::vector<Eigen::Vector2d> places);

  double area_m2() const { return area_m2_; }
  // Inside, or no further outside than `margin_m`; a negative margin asks for a distance inside.
  bool contains(const Eigen::Vector2d& p, double margin_m) const;

 private:
  std::vector<Eigen::Vector2d> corners_;  // counter-clockwise
  double area_m2_ = 0;
};

}  // namespace bole::survey
