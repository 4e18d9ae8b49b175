// Where the 3-D view is seen from, to come back to it.
#pragma once

#include <Eigen/Core>

namespace bole::desktop {

struct ViewPoint {
  Eigen::Vector3d eye = Eigen::Vector3d::Zero(), centre = Eigen::Vector3d::Zero();  // world coordinates, metres
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  bool parallel = false;
  double half_height_m = 1;  // of what a parallel view shows
};

}  // namespace bole::desktop
