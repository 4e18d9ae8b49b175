// A circle through the points of one stem, and whether the stems of a cloud have two walls.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "cloud/first_sight.h"

namespace bole {
inline namespace cloud {
namespace sight {

struct RoughCircle {
  double radius_m = std::numeric_limits<double>::quiet_NaN();
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  std::vector<Eigen::Vector2d> points;  // on it
};

// By least squares of the algebraic distance (Kasa), points far off it left out step by step.
RoughCircle rough_circle(std::vector<Eigen::Vector2d> points);

// Sets doubled_by_m and doubled_bearing_deg where the circles show two walls.
void see_doubled_walls(const std::vector<RoughCircle>& circles, FirstSight& out);

}  // namespace sight
}  // namespace cloud
}  // namespace bole
