// A block of vine rows with posts and wires, what stands about it, and the way a robot drives through it.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "sim/core/plot/forest.h"
#include "sim/core/plot/vegetation.h"

namespace bole::sim {

inline constexpr double shed_reach_m = 7;  // no tree stands nearer to the middle of a shed

// The middles of the sheds beyond the block.
std::vector<Eigen::Vector2d> shed_places(const PlotRecipe& recipe);

// Adds vines, posts, wires and sheds to the scene; the vines' feet and the posts to the obstacles.
void add_vineyard(SceneModel& scene, Vegetation& vegetation, const Forest& forest, std::uint64_t seed);

// All alleys one after the other, turning on the headlands; then back, each alley in the other direction; then the
// first `repeats` alleys once more as at first.
std::vector<Eigen::Vector2d> vineyard_pattern(const VineyardRecipe& vineyard);

}  // namespace bole::sim
