// Feet of upright structures as evidence against a terrain that lies above them.
#pragma once

#include <cstdint>
#include <vector>

#include "ground/core/columns.h"
#include "ground/core/low_points.h"
#include "ground/core/point_grid.h"

namespace bole::ground {

constexpr double max_foot_depth_m = 0.30;  // of a foot below the terrain

// Indices of the columns that begin more than max_foot_depth_m below the surface `terrain` (heights of the cells of
// `shape`, relative to PointCloud::origin; NaN: none) and pass through it. Stems end at the ground: there it is too
// high.
std::vector<std::uint32_t> columns_through(const std::vector<UprightColumn>& columns, const GridShape& shape,
                                           const std::vector<float>& terrain);

// The candidates for ground once the feet of the columns `low` count as ground: what lies above the plane through the
// feet around it is left out as far as `reach_m` from them, and the feet are the candidates of their cells.
struct FootedCandidates {
  std::vector<LowPoint> candidates;  // in order of cells
  std::vector<std::uint32_t> feet;   // those that are feet
};
FootedCandidates with_feet(const std::vector<LowPoint>& candidates, const std::vector<UprightColumn>& columns,
                           const std::vector<std::uint32_t>& low, const GridShape& shape, double reach_m);

}  // namespace bole::ground
