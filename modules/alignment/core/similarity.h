// A motion with a scale.
#pragma once

#include <Eigen/Core>

namespace bole::alignment {

// Metres. A point p goes to `to` + scale turn (p - from): about a point near the cloud, so that coordinates of seven
// digits lose nothing.
struct Similarity {
  Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
  double scale = 1;
  Eigen::Vector3d from = Eigen::Vector3d::Zero(), to = Eigen::Vector3d::Zero();

  Eigen::Vector3d of(const Eigen::Vector3d& p) const { return to + scale * (turn * (p - from)); }
};

}  // namespace bole::alignment
