#include "ground/core/model_ground.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/angles.h"
#include "cloud/first_sight.h"
#include "ground/core/fill_holes.h"
#include "ground/core/heights.h"
#include "ground/core/low_points.h"
#include "ground/core/point_grid.h"
#include "ground/core/terrain.h"
#include "ground/core/tin_filter.h"

namespace bole::ground {
namespace {

constexpr float missing = std::numeric_limits<float>::quiet_NaN();

Raster make_raster(const PointCloud& cloud, const GridShape& shape, const char* quantity) {
  Raster r;
  r.origin = cloud.origin.head<2>() + shape.corner;
  r.cell_m = shape.cell_m, r.nx = shape.nx, r.ny = shape.ny;
  r.axes = cloud.axes, r.crs_wkt = cloud.crs_wkt, r.quantity = quantity;
  r.values.assign(shape.cells(), missing);
  return r;
}

std::vector<float> surface_heights(const GroundSurface& surface, const GridShape& shape) {
  std::vector<float> heights(shape.cells(), missing);
  rasterise(surface.points, surface.triangles, shape, heights);
  return heights;
}

void tell(const GroundModel& model, const PointCloud& cloud, const TerrainFit& fit, std::size_t points_in_grid,
          Report& report) {
  const auto known =
      std::count_if(model.dem.values.begin(), model.dem.values.end(), [](float z) { return !std::isnan(z); });
  const auto filled = std::count(model.filled.values.begin(), model.filled.values.end(), 1.0F);
  const auto count = [&](std::uint8_t c) {
    return std::count(model.classification.begin(), model.classification.end(), c);
  };
  const double cell_area = model.dem.cell_m * model.dem.cell_m;
  const double share = known > 0 ? 100.0 * static_cast<double>(filled) / static_cast<double>(known) : 0.0;
  report.counts["points"] = static_cast<std::int64_t>(cloud.size());
  report.counts["ground_points"] = count(2);
  report.counts["low_noise_points"] = count(7);
  report.counts["dem_cells"] = known;
  report.counts["filled_cells"] = filled;
  report.metrics["filled_share"] = {share, Unit::percent};
  report.metrics["ground_scatter"] = {100.0 * fit.mean_sigma_m, Unit::centimetre};
  report.metrics["dem_area"] = {static_cast<double>(known) * cell_area, Unit::square_metre};
  report.message = fmt::format(
      "Terrain model of {:.0f} m2 in cells of {} m, {:.1f} % of them filled; {} ground points scatter by {:.1f} cm.",
      static_cast<double>(known) * cell_area, number_text(model.dem.cell_m), share, count(2), 100 * fit.mean_sigma_m);
  if (points_in_grid < cloud.size())
    report.warn(fmt::format("{} points have coordinates that are not finite: they got no height",
                            cloud.size() - points_in_grid));
  const auto outside = std::count_if(model.height_above_ground.begin(), model.height_above_ground.end(),
                                     [](float h) { return std::isnan(h); }) -
                       static_cast<std::ptrdiff_t>(cloud.size() - points_in_grid);
  report.counts["points_without_height"] = outside;
  if (share > 50)
    report.warn(
        fmt::format("{:.0f} % of the terrain model is filled: the ground was seldom seen, or cell ({} m) is small "
                    "for this density of points",
                    share, number_text(model.dem.cell_m)));
}

// Height that all but one in a thousand points lie above: a stray point below does not count.
float lowest_height(const PointCloud& cloud) {
  std::vector<float> heights;
  heights.reserve(cloud.size());
  for (const auto& p : cloud.positions())
    if (p.allFinite()) heights.push_back(p.z());
  const auto rank = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 1000);
  std::nth_element(heights.begin(), rank, heights.end());
  return *rank;
}

// A level plane for a cloud without ground. Every cell counts as filled: no ground was seen.
GroundModel level_ground(const PointCloud& cloud, const GridShape& shape, const GroundOptions& options,
                         const Run& run) {
  GroundModel model{make_raster(cloud, shape, "elevation_m"), make_raster(cloud, shape, "filled"), {}, {}, {}};
  const double height = cloud.origin.z() + static_cast<double>(lowest_height(cloud));
  std::ranges::fill(model.dem.values, static_cast<float>(height));
  std::ranges::fill(model.filled.values, 1.0F);
  model.height_above_ground = heights_above(cloud, model.dem, run);
  model.classification = classify(cloud, model.height_above_ground, options);
  model.report.counts["points"] = static_cast<std::int64_t>(cloud.size());
  model.report.message = fmt::format("Level ground at {:.2f} m, the lowest points of the cloud.", height);
  model.report.warn("heights are counted from the lowest points, not from ground");
  return model;
}

// A tree that was cut out has no ground around its foot.
bool is_single_tree(const PointCloud& cloud) {
  return fact_text(cloud.facts, facts::kind) == choice_name(CloudKind::single_tree);
}

}  // namespace

GroundModel model_ground(const PointCloud& cloud, const GroundOptions& options, const Run& run) {
  run.report(0.0, "Sorting points into cells");
  const GridShape shape = grid_over(cloud, options.cell);
  const PointGrid grid(cloud, shape, run);
  if (options.method == GroundMethod::lowest || is_single_tree(cloud)) return level_ground(cloud, shape, options, run);

  run.report(0.35, "Finding ground");
  const auto candidates =
      lowest_groups(cloud, grid, {options.roughness, std::tan(radians(options.max_slope_deg))}, run);
  const auto surface = tin_ground(candidates, shape, options, run);

  run.report(0.60, "Fitting the terrain");
  const auto prior = surface_heights(surface, shape);
  auto fit = fit_terrain(cloud, grid, prior, options, run);
  if (fit.cells == 0)
    throw bad_input("no points lie within band (" + number_text(options.band) + " m) of the first ground surface", "some",
                  "Raise band, or lower seed");

  run.report(0.80, "Filling holes");
  const auto filled = fill_holes(shape, prior, options.fill_distance, fit.height);
  GroundModel model{make_raster(cloud, shape, "elevation_m"), make_raster(cloud, shape, "filled"), {}, {}, {}};
  for (std::size_t c = 0; c < shape.cells(); ++c) {
    if (std::isnan(fit.height[c])) continue;
    model.dem.values[c] = static_cast<float>(static_cast<double>(fit.height[c]) + cloud.origin.z());
    model.filled.values[c] = filled[c] ? 1.0F : 0.0F;
  }

  run.report(0.85, "Heights above ground");
  model.height_above_ground = heights_above(cloud, model.dem, run);
  model.classification = classify(cloud, model.height_above_ground, options);
  tell(model, cloud, fit, grid.size(), model.report);
  run.report(1.0, "Terrain model done");
  return model;
}

}  // namespace bole::ground
