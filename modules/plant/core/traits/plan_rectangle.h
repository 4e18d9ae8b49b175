// The rectangle around a plant in plan.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace bole::plant {

// The rectangle of least area around the plant in plan.
struct PlanRectangle {
  double length = 0, width = 0;              // length >= width
  std::array<Eigen::Vector2d, 4> corners{};  // in order around it
};

// Of at least three points that do not lie on one line; else zero.
PlanRectangle smallest_rectangle(const std::vector<Eigen::Vector2d>& points);

struct RectangleScatter {
  double length = 0, width = 0;  // standard deviations, metres
};

// What errors of the outline make of the smallest rectangle. Rectangles turned otherwise often have nearly the same
// area, and small errors decide between them: so the outline is moved in and out, patch by patch, by `side_sd`, many
// times over. `patch`: what moves together, metres.
RectangleScatter rectangle_scatter(const std::vector<Eigen::Vector2d>& points, double side_sd, double patch);

}  // namespace bole::plant
