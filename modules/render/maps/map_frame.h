// Frames of plan maps: equal scales along both axes, and what stands below them.
#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "render/draw/axes.h"
#include "render/draw/furniture.h"

namespace bole::render {

// The rectangle about points, metres.
struct MapExtent {
  static constexpr double inf = std::numeric_limits<double>::infinity();
  Eigen::Vector2d lo{inf, inf}, hi{-inf, -inf};
  void include(const Eigen::Vector2d& p) {
    if (!p.allFinite()) return;
    lo = lo.cwiseMin(p);
    hi = hi.cwiseMax(p);
  }
  bool empty() const { return !(lo.x() <= hi.x()); }
};

// Space below the box of a map for its labels, scale bar and legend.
inline constexpr double map_furniture_mm = 23;

// A map of `extent` with a margin, `width_mm` wide, its left upper corner at `corner`.
Frame map_frame(MapExtent extent, const Eigen::Vector2d& corner, double width_mm);

// The extent in the middle of a box, as large as fits, one scale along both axes.
Frame fitted_frame(MapExtent extent, const Box& box);

// A frame all around, "x (m)" and "y (m)".
AxesStyle map_axes();

// Scale bar and legend below a map.
void draw_below(Canvas& canvas, const Frame& frame, const std::vector<LegendEntry>& entries);

}  // namespace bole::render
