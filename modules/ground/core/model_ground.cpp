#include "ground/core/model_ground.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/angles.h"
#include "base/statistics.h"
#include "cloud/core/height_facts.h"
#include "cloud/first_sight.h"
#include "ground/core/columns.h"
#include "ground/core/fill_holes.h"
#include "ground/core/given_ground.h"
#include "ground/core/height_reference.h"
#include "ground/core/heights.h"
#include "ground/core/low_points.h"
#include "ground/core/point_grid.h"
#include "ground/core/scales.h"
#include "ground/core/stem_feet.h"
#include "ground/core/terrain.h"
#include "ground/core/tin_filter.h"

namespace bole::ground {
namespace {

// Low noise per ground point. Clouds whose ground was seen have less than 0.02.
constexpr double max_noise_share = 0.5;
// The height of cover_above(). Plots of the real clouds have up to 0.01, slash and litter 0.09 and more.
constexpr double max_cover_m = 0.05;
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

// A plane at one height. Every cell counts as filled: no ground was seen.
GroundModel level_ground(const PointCloud& cloud, const GridShape& shape, double height, const GroundScales& scales,
                         const Run& run) {
  GroundModel model{make_raster(cloud, shape, "elevation_m"), make_raster(cloud, shape, "filled"), {}, {}, {}, {}};
  std::ranges::fill(model.dem.values, static_cast<float>(height));
  std::ranges::fill(model.filled.values, 1.0F);
  model.height_above_ground = heights_above(cloud, model.dem, run);
  model.classification = classify(cloud, model.height_above_ground, scales);
  model.report.counts["points"] = static_cast<std::int64_t>(cloud.size());
  model.report.counts["ground_points"] = std::ranges::count(model.classification, 2);
  return model;
}

GroundModel lowest_ground(const PointCloud& cloud, const GridShape& shape, const GroundScales& scales, const Run& run) {
  const double height = cloud.origin.z() + static_cast<double>(lowest_height(cloud));
  auto model = level_ground(cloud, shape, height, scales, run);
  model.source = TerrainSource::lowest;
  model.report.message = fmt::format("Level ground at {:.2f} m, the lowest points of the cloud.", height);
  model.report.warn("heights are counted from the lowest points, not from ground");
  return model;
}

// A tree that was cut out has no ground around its foot.
bool is_single_tree(const PointCloud& cloud) {
  return fact_text(cloud.facts, facts::kind) == choice_name(CloudKind::single_tree);
}

// z is height above ground. Cells with points at 0 show ground and do not count as filled.
GroundModel normalised_ground(const PointCloud& cloud, const GridShape& shape, const GroundScales& scales,
                              const std::string& evidence, const Run& run) {
  auto model = level_ground(cloud, shape, 0, scales, run);
  model.source = TerrainSource::normalised;
  const auto& positions = cloud.positions();
  for (std::size_t i = 0; i < positions.size(); ++i)
    if (model.classification[i] == 2 && positions[i].allFinite())
      model.filled.values[shape.index(std::clamp(shape.column(static_cast<double>(positions[i].x())), 0, shape.nx - 1),
                                      std::clamp(shape.row(static_cast<double>(positions[i].y())), 0, shape.ny - 1))] =
          0;
  model.report.message = "Normalised cloud: z is the height above ground.";
  model.report.find(Severity::note, "cloud_is_normalised",
                    fmt::format("heights are taken from the cloud as they are: {}. If z is not the height above "
                                "ground, set method=tin",
                                evidence));
  return model;
}

// The terrain by triangulation and local fits.
class TinTerrain {
 public:
  TinTerrain(const PointCloud& cloud, const PointGrid& grid, const std::vector<std::uint8_t>& given,
             const GroundScales& scales, const Run& run)
      : cloud_(cloud),
        grid_(grid),
        shape_(grid.shape()),
        given_(given_candidates(cloud, given, shape_)),
        scales_(scales),
        run_(run) {}

  GroundModel model(const std::vector<LowPoint>& candidates, const std::vector<UprightColumn>& columns) {
    find_surface(candidates, columns);
    run_.report(0.60, "Fitting the terrain");
    auto fit = fit_terrain(cloud_, grid_, prior_, scales_, run_);
    keep_feet(columns, fit);
    if (fit.cells == 0 && feet_.empty())
      throw bad_input("no points lie within band (" + number_text(scales_.band) + " m) of the first ground surface",
                      "some", "Raise band, or lower seed");
    run_.report(0.80, "Filling holes");
    auto filled = fill_holes(shape_, prior_, scales_.fill_distance, fit.height);
    for (const auto cell : foot_cells_) filled[cell] = 1;
    GroundModel out{make_raster(cloud_, shape_, "elevation_m"), make_raster(cloud_, shape_, "filled"), {}, {}, {}, {}};
    for (std::size_t c = 0; c < shape_.cells(); ++c) {
      if (std::isnan(fit.height[c])) continue;
      out.dem.values[c] = static_cast<float>(static_cast<double>(fit.height[c]) + cloud_.origin.z());
      out.filled.values[c] = filled[c] ? 1.0F : 0.0F;
    }
    run_.report(0.85, "Heights above ground");
    out.height_above_ground = heights_above(cloud_, out.dem, run_);
    out.classification = classify(cloud_, out.height_above_ground, scales_);
    out.source = feet_.empty() ? TerrainSource::ground : TerrainSource::feet;
    tell(out, cloud_, fit, grid_.size(), out.report);
    out.report.counts["upright_structures"] = static_cast<std::int64_t>(columns.size());
    tell_feet(columns.size(), out.report);
    return out;
  }

 private:
  // Feet below the surface pull it down, and what was hidden below it may show more of them.
  void find_surface(std::vector<LowPoint> candidates, const std::vector<UprightColumn>& columns) {
    constexpr int max_rounds = 3;
    std::vector<std::uint32_t> pinned;
    const auto take = [&](FootedCandidates found) {
      if (!given_.empty()) found = with_given(found, given_);
      candidates = std::move(found.candidates);
      pinned = std::move(found.feet);
    };
    if (!given_.empty()) take({std::exchange(candidates, {}), {}});
    for (int round = 0; round < max_rounds; ++round) {
      prior_ = surface_heights(tin_ground(candidates, pinned, shape_, scales_, run_), shape_);
      const auto through = columns_through(columns, shape_, prior_);
      const auto before = feet_.size();
      feet_.insert(feet_.end(), through.begin(), through.end());
      std::ranges::sort(feet_);
      feet_.erase(std::unique(feet_.begin(), feet_.end()), feet_.end());
      if (feet_.size() == before) return;
      take(with_feet(candidates, columns, feet_, shape_, 2 * scales_.seed));
    }
    prior_ = surface_heights(tin_ground(candidates, pinned, shape_, scales_, run_), shape_);
  }

  // Around a foot there is bark and no ground: the terrain runs through the foot itself.
  void keep_feet(const std::vector<UprightColumn>& columns, TerrainFit& fit) {
    for (const auto i : feet_) {
      const auto& p = columns[i].foot;
      const int ix = std::clamp(shape_.column(p.x()), 0, shape_.nx - 1),
                iy = std::clamp(shape_.row(p.y()), 0, shape_.ny - 1);
      for (int jy = std::max(0, iy - 1); jy <= std::min(shape_.ny - 1, iy + 1); ++jy)
        for (int jx = std::max(0, ix - 1); jx <= std::min(shape_.nx - 1, ix + 1); ++jx)
          fit.height[shape_.index(jx, jy)] = missing;
    }
    for (const auto i : feet_) {
      const auto& p = columns[i].foot;
      const auto cell = shape_.index(std::clamp(shape_.column(p.x()), 0, shape_.nx - 1),
                                     std::clamp(shape_.row(p.y()), 0, shape_.ny - 1));
      if (std::isnan(prior_[cell])) continue;
      fit.height[cell] = prior_[cell];
      foot_cells_.push_back(cell);
    }
  }

  void tell_feet(std::size_t columns, Report& report) const {
    if (feet_.empty()) return;
    report.counts["feet_as_ground"] = static_cast<std::int64_t>(feet_.size());
    report.find(Severity::look, "terrain_from_stem_feet",
                fmt::format("{} of {} upright structures reach further down than the ground that was seen around them: "
                            "the terrain runs through their feet. Breast height is too high there by what is missing "
                            "of the foot: give the cloud with its ground, or look at these stems",
                            feet_.size(), columns));
  }

  const PointCloud& cloud_;
  const PointGrid& grid_;
  const GridShape& shape_;
  std::vector<LowPoint> given_;  // ground that a person pointed out
  const GroundScales& scales_;
  const Run& run_;
  std::vector<float> prior_;
  std::vector<std::uint32_t> feet_;  // columns whose feet count as ground
  std::vector<std::size_t> foot_cells_;
};

// Median height of the points near the terrain. Ground that is seen lies about zero and outnumbers what grows on it.
double cover_above(const std::vector<float>& heights) {
  constexpr float near_m = 0.35F;
  std::vector<double> low;
  for (const float h : heights)
    if (std::abs(h) < near_m) low.push_back(static_cast<double>(h));
  return low.empty() ? 0 : upper_median(std::move(low));
}

// What a person must know before the terrain is used.
void judge_terrain(const HeightReference& reference, const std::vector<float>& heights, Report& report) {
  const auto ground = report.counts["ground_points"], noise = report.counts["low_noise_points"];
  if (static_cast<double>(noise) > max_noise_share * static_cast<double>(ground))
    report.find(Severity::refused, "ground_more_noise_than_ground",
                fmt::format("{} points lie below the terrain and only {} on it: it is not the ground. Set "
                            "method=normalised if z is the height above ground, method=lowest for a tree that was cut "
                            "out without ground, or give the cloud with its ground",
                            noise, ground));
  if (const double cover_m = cover_above(heights); cover_m > max_cover_m)
    report.find(
        Severity::look, "ground_covered",
        fmt::format("half of the points near the terrain lie {:.0f} cm above it or higher: litter, herbs, slash, or "
                    "passes that do not meet. Breast height may be too high by as much. Compare some stems with "
                    "the plot",
                    100 * cover_m));
  if (reference.level_cut)
    report.find(Severity::refused, "stems_cut_off",
                fmt::format("all stems begin at z = {:.2f} m and no ground was seen: the cloud was cut there. Set "
                            "method=normalised if z is the height above ground, else give the cloud with its ground",
                            reference.cut_z));
}

// What is seen before the terrain is made.
struct GroundSight {
  GroundSight(const PointCloud& cloud, const GridShape& shape, const GroundScales& scales, const Run& run)
      : grid(cloud, shape, run) {
    run.report(0.35, "Finding ground");
    candidates = lowest_groups(cloud, grid, {scales.roughness, std::tan(radians(scales.max_slope_deg))}, run);
    if (scales.cell >= min_column_cell_m && scales.cell <= max_column_cell_m)
      columns = upright_columns(cloud, grid, run);
    reference = height_reference(cloud, candidates, columns);
  }

  PointGrid grid;
  std::vector<LowPoint> candidates;
  std::vector<UprightColumn> columns;
  HeightReference reference;
};

}  // namespace

std::string evidence_of_normalised(const PointCloud& cloud, const Run& run) {
  if (is_single_tree(cloud)) return {};
  const auto scales = scales_for(cloud, {});
  const auto reference = GroundSight(cloud, grid_over(cloud, scales.cell), scales, run).reference;
  return reference.above_ground ? reference.evidence : std::string();
}

GroundModel model_ground(const PointCloud& cloud, const GroundOptions& options, const Run& run,
                         const std::vector<std::uint8_t>& given) {
  run.report(0.0, "Sorting points into cells");
  const auto scales = scales_for(cloud, options);
  const GridShape shape = grid_over(cloud, scales.cell);
  if (options.method == GroundMethod::lowest || (!options.method && is_single_tree(cloud)))
    return lowest_ground(cloud, shape, scales, run);
  if (options.method == GroundMethod::normalised)
    return normalised_ground(cloud, shape, scales, "method is normalised", run);
  const GroundSight seen(cloud, shape, scales, run);
  if (!options.method && seen.reference.above_ground)
    return normalised_ground(cloud, shape, scales, seen.reference.evidence, run);

  auto model = TinTerrain(cloud, seen.grid, given, scales, run).model(seen.candidates, seen.columns);
  judge_terrain(seen.reference, model.height_above_ground, model.report);
  run.report(1.0, "Terrain model done");
  return model;
}

GroundModel ground_of(const PointCloud& cloud, const Raster& terrain, const GroundOptions& options, const Run& run) {
  const auto scales = scales_for(cloud, options);
  GroundModel model{terrain, terrain, {}, {}, {}, {}};
  model.filled.quantity = "filled";
  for (float& v : model.filled.values) v = std::isnan(v) ? missing : 0.0F;
  model.height_above_ground = heights_above(cloud, model.dem, run);
  model.classification = classify(cloud, model.height_above_ground, scales);
  const auto below = std::ranges::count_if(model.height_above_ground, [](float height) { return !std::isnan(height); });
  if (below == 0)
    throw bad_input(fmt::format("the terrain given lies below none of {} points", cloud.size()),
                    "a terrain model of the same place, in the same coordinates", "Check the file of the terrain");
  model.report.counts["points"] = static_cast<std::int64_t>(cloud.size());
  model.report.counts["ground_points"] = std::ranges::count(model.classification, 2);
  model.report.counts["points_without_height"] = static_cast<std::int64_t>(cloud.size()) - below;
  model.report.message = fmt::format("Heights above the terrain given, for {} of {} points.", below, cloud.size());
  return model;
}

}  // namespace bole::ground
