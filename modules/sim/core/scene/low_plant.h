// A plant below the trees that the wind moves as a whole.
#pragma once

#include <Eigen/Core>

namespace bole::sim {

enum class LowPlantKind { sapling, shrub, grass };

struct LowPlant {
  int id = 0;  // below 0: those above are trees
  LowPlantKind kind = LowPlantKind::shrub;
  Eigen::Vector3d foot = Eigen::Vector3d::Zero();
  Eigen::Vector2d lean = Eigen::Vector2d::Zero();  // metres per metre
  double height_m = 0;
};

}  // namespace bole::sim
