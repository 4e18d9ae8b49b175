#include "ground/core/scales.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/option.h"
#include "cloud/core/whole/occupied_cells.h"
#include "cloud/core/whole/whole_cloud.h"
#include "ground/core/point_grid.h"

namespace bole::ground {
namespace {

constexpr double finest_m = finest_spacing_m, coarsest_m = coarsest_spacing_m;

// The finest grid that is not refused for its size.
GridShape finest_grid(const PointCloud& cloud) {
  for (double cell = finest_m; cell < coarsest_m; cell *= 2)
    if (fits_grid(cloud, cell)) return grid_over(cloud, cell);
  return grid_over(cloud, fits_grid(cloud, coarsest_m) ? coarsest_m : finest_m);
}

}  // namespace

double point_spacing(const PointCloud& cloud) {
  const GridShape shape = finest_grid(cloud);
  OccupiedCells level(shape.nx, shape.ny);
  for (const auto& p : cloud.positions())
    if (p.allFinite())
      level.occupy(std::clamp(shape.column(static_cast<double>(p.x())), 0, shape.nx - 1),
                   std::clamp(shape.row(static_cast<double>(p.y())), 0, shape.ny - 1));
  return spacing_of(std::move(level), shape.cell_m);
}

GroundScales scales_for(const PointCloud& cloud, const GroundOptions& options) {
  const auto of_whole = spacing_of_whole(cloud.facts);
  const double spacing = of_whole ? *of_whole : point_spacing(cloud), coarser = spacing / finest_m;
  GroundScales s;
  s.cell = options.cell.value_or(std::max(finest_m, spacing / 2));  // sparse clouds lose edges in larger cells
  s.seed = options.seed.value_or(std::max(4.0 * std::pow(coarser, 1.3), 4 * s.cell));
  s.max_slope_deg = options.max_slope_deg;
  s.max_angle_deg = options.max_angle_deg.value_or(15.0 * std::pow(coarser, -0.3));
  s.max_distance = options.max_distance.value_or(0.6 * std::pow(coarser, 0.6));
  s.roughness = options.roughness.value_or(0.10 * std::sqrt(coarser));
  s.band = options.band.value_or(0.30 * std::pow(coarser, 0.37));
  s.tolerance = options.tolerance.value_or(0.15 * std::pow(coarser, 0.7));
  s.noise_depth = options.noise_depth.value_or(2 * s.tolerance);
  s.fill_distance = options.fill_distance.value_or(10.0 * coarser);
  s.keep_classes = options.keep_classes;
  if (s.seed < 2 * s.cell)
    throw bad_input("seed is " + number_text(s.seed) + " m and cell is " + number_text(s.cell) + " m",
                    "seed of at least twice cell", "Raise seed or lower cell");
  return s;
}

}  // namespace bole::ground
