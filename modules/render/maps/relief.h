// Terrain as maps show it: tints by height, hill shading, contour lines.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "cloud/raster.h"
#include "render/draw/axes.h"
#include "render/draw/color.h"

namespace bole::render {

struct RasterCells {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // x1, y1: one past the last
};
RasterCells all_cells(const Raster& raster);

// Nothing where no cell has a value.
std::optional<Interval> value_range(const Raster& raster, const RasterCells& cells);

// Light from the north-west, 45 degrees above the horizon; 1 on level ground, 0.35 to 1.25. Cell with a value.
double hill_shade(const Raster& raster, int ix, int iy);

// `t`: 0 at the foot of what is shown, 1 at its top.
Color terrain_color(double t, double shade);

// A piece of a contour line between two sides of a square of cell centres, metres.
struct ContourPiece {
  Eigen::Vector2d a, b;
  double height_m = 0;
};
double contour_step_m(const Interval& heights);  // a round one for about eight lines, 5 cm at least
// Marching squares; none through holes.
std::vector<ContourPiece> contours(const Raster& raster, const RasterCells& cells, const Interval& heights,
                                   double step_m);

}  // namespace bole::render
