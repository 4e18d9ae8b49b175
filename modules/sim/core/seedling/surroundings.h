// What stands around a seedling: pot, soil, mat, table, things on it, and a room.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/core/seedling/scene_part.h"
#include "sim/core/seedling/seedling_recipe.h"

namespace bole::sim {

struct Pot {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();                                  // of its bottom
  double top_radius = 0, bottom_radius = 0, height = 0, soil_below = 0, relief = 0;  // metres

  double wall() const { return 0.002; }
  double inner_radius(double above_bottom) const {
    return bottom_radius + (top_radius - bottom_radius) * above_bottom / height - wall();
  }
  // Middle of the soil, at its mean height.
  Eigen::Vector3d soil_middle() const { return middle + Eigen::Vector3d(0, 0, height - soil_below); }
};

Eigen::Vector3d mat_middle();  // where turntables turn

// Stands in the middle of the mat (world axes: those of the mat).
Pot draw_pot(const SeedlingPot& recipe, std::uint64_t seed);

ScenePart pot_part(const Pot& pot, std::uint64_t seed);
// Lumps with a mean of zero over the pot, level at the foot of the stem.
ScenePart soil_part(const Pot& pot, std::uint64_t seed);
// The sheet, its upper side at z = 0.
ScenePart mat_part();
// A turntable below the mat, in the axes of the mat.
ScenePart turntable_part();
// Table, things on its border, floor and walls. Nothing of it lies between the plant and a camera within 0.85 m of it.
std::vector<ScenePart> room_parts(std::uint64_t seed);

inline constexpr double table_below_mat = 0.002;  // metres

}  // namespace bole::sim
