// Where something may lie among the trees, and what felling left.
#pragma once

#include "sim/core/plot/vegetation.h"

namespace bole::sim {

// No stem or target within `distance` of a place, and no vine row.
bool is_free_ground(const Forest& forest, const Eigen::Vector3d& at, double distance);

// Stumps of felled trees, 0.15 to 0.6 m high, some of them tall ones of up to 1.2 m.
void add_stumps(SceneModel& scene, const Forest& forest, Vegetation& vegetation, std::uint64_t seed);

}  // namespace bole::sim
