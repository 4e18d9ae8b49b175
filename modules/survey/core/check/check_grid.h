// The cells of a check, and what was measured in each.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/run.h"
#include "cloud/plot_area.h"
#include "cloud/point_cloud.h"
#include "cloud/raster.h"
#include "cloud/table.h"
#include "cloud/trajectory.h"
#include "survey/core/check/check_options.h"

namespace bole::survey {

// What a check looks at; a null pointer where it is not there. Cloud or stems must be.
struct CheckInputs {
  const PointCloud* points = nullptr;
  const Raster* dem = nullptr;
  const Trajectory* trajectory = nullptr;
  const Table* stems = nullptr;
  const Table* plot = nullptr;
  const Table* loops = nullptr;
  const Table* targets = nullptr;
};

struct CheckCell {
  bool inside = false;  // of the region that is judged
  std::uint32_t points = 0, ground_points = 0;
  int directions = 0;         // of 16 sectors of 22.5 deg from which the sensor saw it
  double view_span_deg = 0;   // 360 less the widest sector without a view; NaN where views are not known
  double walk_m = 0;          // distance from the walk; NaN without one
  double thickness_cm = 0;    // half the middle 68 % of the heights of its ground points; NaN with few points
  double pass_spread_cm = 0;  // greatest difference between the ground of two passes; NaN with fewer than two
};

struct CheckGrid {
  Eigen::Vector2d low = Eigen::Vector2d::Zero();
  double cell_m = 1;
  int nx = 0, ny = 0;
  std::vector<CheckCell> cells;  // index iy * nx + ix
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
  bool bounded = false;  // the region is a plot with a boundary
  bool has_heights = false, has_views = false, has_passes = false;

  std::optional<std::size_t> index(const Eigen::Vector2d& p) const {
    const Eigen::Vector2d q = (p - low) / cell_m;
    if (!(q.x() >= 0 && q.y() >= 0 && q.x() < nx && q.y() < ny)) return std::nullopt;
    return static_cast<std::size_t>(q.y()) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(q.x());
  }
  Eigen::Vector2d middle(std::size_t i) const {
    const auto n = static_cast<std::size_t>(nx), row = i / n;
    return low + cell_m * Eigen::Vector2d(static_cast<double>(i % n) + 0.5, static_cast<double>(row) + 0.5);
  }
  std::size_t inside_cells() const;
};

// Height above ground of every point, from its array or from the terrain model; NaN where it is not known. Empty where
// neither is there.
std::vector<float> heights_of(const CheckInputs& inputs, const Run& run);

// The pass of every point: the array `pass`, else stretches of 20 s of the array `time`. Empty where neither tells two
// passes apart.
std::vector<std::int32_t> passes_of(const PointCloud& points);

// The region that is judged: the plot; without a boundary what lies among the stems, or around the cloud's ground that
// encloses it. Cells are measured from the points.
CheckGrid measure_cells(const CheckInputs& inputs, const PlotArea& area, const std::vector<float>& heights,
                        const std::vector<std::int32_t>& passes, const CheckOptions& options, const Run& run);

}  // namespace bole::survey
