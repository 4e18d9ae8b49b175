// Upright structures that stand out of what is around them, as stems do: where they end the ground is.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "ground/core/point_grid.h"

namespace bole::ground {

constexpr double min_column_cell_m = 0.1;  // cells that tell a stem from what is beside it
constexpr double max_column_cell_m = 0.35;

struct UprightColumn {
  Eigen::Vector3d foot;  // its lowest points, relative to PointCloud::origin
  double top_z = 0;      // where it breaks off first
};

// Columns of points without a gap, as wide as a stem, tall, and at least four times as dense as what is half a metre
// beside them. One per structure, in order of cells. A foot is the end of what was seen: grass, slash or a cut may hide
// the ground below it. The cells of `grid` are as small as above.
std::vector<UprightColumn> upright_columns(const PointCloud& cloud, const PointGrid& grid, const Run& run);

}  // namespace bole::ground
