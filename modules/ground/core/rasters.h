// Rasters derived from a terrain model or a cloud.
#pragma once

#include "base/run.h"
#include "cloud/point_cloud.h"
#include "cloud/raster.h"

namespace bole::ground {

// Slope of the terrain in degrees (quantity "slope_deg"), by Horn's (1981) third-order differences over 3 x 3 cells; at
// borders and beside holes by the differences there are. NaN where the DEM is NaN or has no neighbour in x or in y.
Raster slope_deg(const Raster& dem);

// Canopy height model (quantity "canopy_height_m"): the greatest value of the array height_above_ground in each cell,
// at least 0; NaN where a cell has no point with a height. On the grid of `dem` when `cell_m` is its cell size, else on
// a grid with the same corner and extent. Throws Error{bad_input} when the array is absent or cell_m is not positive,
// Error{cancelled}.
Raster canopy_height(const PointCloud& cloud, const Raster& dem, double cell_m, const Run& run = {});

}  // namespace bole::ground
