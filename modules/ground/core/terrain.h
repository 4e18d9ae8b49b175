// Terrain heights by local robust fits to the band of ground points.
#pragma once

#include "cloud/raster.h"
#include "ground/core/point_grid.h"
#include "ground/core/scales.h"

namespace bole::ground {

struct TerrainFit {
  std::vector<float> height;  // per cell, metres relative to PointCloud::origin; NaN where no ground was seen
  double mean_sigma_m = 0;    // scatter of ground points about the fits, mean over the cells
  std::size_t cells = 0;      // with a fit
};

// For each cell a plane through the points of 3 x 3 cells within `scales.band` of the rough surface `prior` (heights
// of the cells; NaN: none). On noisy clouds the ground is a band some centimetres thick with a tail of grass and litter
// above: the fit starts at the lowest strong peak of the heights, takes its scale from the side below, where no grass
// is, and weighs by Tukey's biweight, so that it follows the middle of the band and neither its lower envelope nor the
// grass. A layer more than scales.roughness above the rough surface is not ground (the foot of a shrub, a stone):
// such cells get no height.
TerrainFit fit_terrain(const PointCloud& cloud, const PointGrid& grid, const std::vector<float>& prior,
                       const GroundScales& scales, const Run& run);

}  // namespace bole::ground
