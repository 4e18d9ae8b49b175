#include "ground/core/scales.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/option.h"
#include "ground/core/point_grid.h"

namespace bole::ground {
namespace {

constexpr double finest_m = 0.25;
constexpr double coarsest_m = 4.0;
constexpr double min_share = 0.4;  // of the cells of covered ground that hold points

struct Occupancy {
  int nx = 0, ny = 0;
  std::vector<bool> holds;

  std::size_t count() const { return static_cast<std::size_t>(std::count(holds.begin(), holds.end(), true)); }
  Occupancy coarser() const {
    Occupancy out{(nx + 1) / 2, (ny + 1) / 2, {}};
    out.holds.assign(static_cast<std::size_t>(out.nx) * static_cast<std::size_t>(out.ny), false);
    for (int iy = 0; iy < ny; ++iy)
      for (int ix = 0; ix < nx; ++ix)
        if (holds[static_cast<std::size_t>(iy) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(ix)])
          out.holds[static_cast<std::size_t>(iy / 2) * static_cast<std::size_t>(out.nx) +
                    static_cast<std::size_t>(ix / 2)] = true;
    return out;
  }
};

Occupancy occupancy(const PointCloud& cloud, const GridShape& shape) {
  Occupancy out{shape.nx, shape.ny, std::vector<bool>(shape.cells(), false)};
  for (const auto& p : cloud.positions()) {
    if (!p.allFinite()) continue;
    const int ix = std::clamp(shape.column(static_cast<double>(p.x())), 0, shape.nx - 1),
              iy = std::clamp(shape.row(static_cast<double>(p.y())), 0, shape.ny - 1);
    out.holds[shape.index(ix, iy)] = true;
  }
  return out;
}

// The finest grid that is not refused for its size.
GridShape finest_grid(const PointCloud& cloud) {
  for (double cell = finest_m; cell < coarsest_m; cell *= 2)
    if (fits_grid(cloud, cell)) return grid_over(cloud, cell);
  return grid_over(cloud, fits_grid(cloud, coarsest_m) ? coarsest_m : finest_m);
}

}  // namespace

double point_spacing(const PointCloud& cloud) {
  const GridShape shape = finest_grid(cloud);
  std::vector<std::size_t> counts;  // of occupied cells, at cell, 2 cell, 4 cell, ...
  auto level = occupancy(cloud, shape);
  counts.push_back(level.count());
  double cell = shape.cell_m;
  for (std::size_t k = 0;; ++k, cell *= 2) {
    while (counts.size() <= k + 2) {
      level = level.coarser();
      counts.push_back(level.count());
    }
    const double share = static_cast<double>(counts[k]) / (16.0 * static_cast<double>(counts[k + 2]));
    if (share >= min_share || cell >= coarsest_m) return cell;
  }
}

GroundScales scales_for(const PointCloud& cloud, const GroundOptions& options) {
  const double spacing = point_spacing(cloud), coarser = spacing / finest_m;
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
