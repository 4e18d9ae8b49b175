// Candidates for ground: in each cell the lowest dense group of points.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "ground/core/point_grid.h"

namespace bole::ground {

struct LowPoint {
  Eigen::Vector3d position;  // mean of the group, relative to PointCloud::origin
  std::uint32_t cell = 0;    // of the grid it was found in
};

struct LowPointLimits {
  double thickness_m = 0.1;    // of a group
  double max_slope_tan = 1.2;  // steepest terrain
};

// One candidate per cell, in order of cells. The group is the lowest one with enough points for the density of the cell
// (one in twenty, at least two in cells of six or more, at most five), so that stray returns below the ground are
// passed over. A group that lies below most candidates of the 5 x 5 cells around it more steeply than the terrain can
// fall is low noise: the next group of the cell takes its place, or none.
std::vector<LowPoint> lowest_groups(const PointCloud& cloud, const PointGrid& grid, const LowPointLimits& limits,
                                    const Run& run);

}  // namespace bole::ground
