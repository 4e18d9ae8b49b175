// Height and breadth of a plant from its points, corrected for their noise.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/run.h"
#include "plant/core/separate/point_grid.h"
#include "plant/core/traits/plan_rectangle.h"
#include "plant/core/traits/tips.h"

namespace bole::plant {

struct Extent {
  double value = 0;  // corrected
  double raw = 0;    // of the points as they are
  double sd = 0;     // standard deviation of the correction, the noise and the sampling
};

struct Extents {
  Extent top, length, width;  // top: the highest z
  Eigen::Vector3d top_point = Eigen::Vector3d::Zero();
  PlanRectangle rectangle;  // of the points as they are
  double noise = 0;         // standard deviation of a point across the surface
  double spacing = 0;
  std::size_t removed = 0;    // points without enough neighbours
  int sides_in_pictures = 0;  // of five (top, and four of the rectangle): those that pictures have measured
};

// The bare sizes of points, z up: the highest z, and the smallest rectangle in plan.
struct PointSizes {
  double top = 0, length = 0, width = 0;
};
PointSizes sizes_of(const Points3& points);

// `plant`: metres, z up. Noise widens every extent, the more the denser the points. So the same noise is added again,
// several times over, and what the extents gain by it is extrapolated back to none (SIMEX: Cook and Stefanski 1994,
// quadratic in the variance). The scatter of that, what half of the
// points would lose, and what the outermost points carry alone make the standard deviation.
Extents measure_extents(const Points3& plant, const Run& run);

// Widens the errors of both sides by what errors of the outline make of the rectangle, which they may turn.
void take_scatter_of_rectangle(const std::vector<Eigen::Vector2d>& plan, Extents& extents);

// Replaces every extent whose outermost places the pictures have measured. An extent with one side measured and the
// other not keeps the correction for noise on that side.
void take_tips(const Points3& plant, const std::vector<Tip>& tips, double reach, Extents& extents);

}  // namespace bole::plant
