// Where trees stand.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "sim/core/plot/recipe.h"

namespace bole::sim {

struct Site {
  Eigen::Vector2d xy = Eigen::Vector2d::Zero();
  bool in_plot = true;
};

// Sites within the plot first, then those of the buffer at the same density. Trees within the plot stand at least 0.3 m
// inside the boundary, the others at least as far outside, so that lean leaves no doubt; the targets stay free.
// Throws Error{bad_input} when the count does not fit.
std::vector<Site> make_layout(const PlotRecipe& recipe, std::uint64_t seed);

}  // namespace bole::sim
