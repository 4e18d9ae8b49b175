// What points are matched to in fixed cells of a map: of each point the one cell that holds it. Surfaces of the eight
// nearest cells (find_target()) reach farther, but a window that moves with the place lies behind every point of a
// convex surface. Its mean is within the bark, and all points are pulled towards what they show, by 5 mm on trunks with
// cells of 0.1 m. In fixed cells the points are those that make the mean, and these pulls cancel.
#pragma once

#include <array>
#include <vector>

#include "slam/core/odometry/registration.h"

namespace bole::slam {

// Many points share a cell, so the targets of all cells are found beforehand.
class CellTargets {
 public:
  // `sigma`: of the ranges, metres. Throws Error{cancelled}.
  CellTargets(const DistributionMap& map, bool line, double sigma, const Run& run);

  // Of the point of the map that was inserted as the one of that index, on the finest level whose cell is planar (or
  // linear) enough; Kind::none where there is none. `cells`: of all points inserted.
  Target of(std::size_t index, const Eigen::Vector3d& point_in_map, const DistributionMap::CellNumbers& cells) const;

 private:
  const DistributionMap& map_;
  std::array<std::vector<Target>, DistributionMap::levels> targets_;  // by cell; means from its centre
};

}  // namespace bole::slam
