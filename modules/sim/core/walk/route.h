// The way over the ground: the paper's pattern of lines, led around trees.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/core/plot/forest.h"
#include "sim/core/plot/vegetation.h"

namespace bole::sim {

// SPEC A13: centre, NW corner, parallel lines `line_spacing_m` apart, SE corner, centre. An odd number of east-west
// lines, as many as fit with that spacing, so that the last one ends in the south-east.
std::vector<Eigen::Vector2d> walk_pattern(double plot_size_m, double line_spacing_m);

// Points about `step_m` apart that follow the way-points, keep 0.5 m from stems (less only where trees leave no such
// gap: down to 0.3 m) and go around shrubs and rocks where that is cheap. The first and last points may be moved to
// free ground. Throws Error{failed} when trees block the way.
std::vector<Eigen::Vector2d> plan_route(const std::vector<Eigen::Vector2d>& way_points, const Forest& forest,
                                        const std::vector<Obstacle>& soft, double step_m);

}  // namespace bole::sim
