// Branches, leaves, forks, shrubs, saplings, grass, rocks and fallen stems.
#pragma once

#include <vector>

#include "sim/core/plot/forest.h"
#include "sim/core/scene/low_plant.h"
#include "sim/core/scene/scene_model.h"

namespace bole::sim {

// A thin stem below the smallest diameter of the plot's trees: real, but not part of its stem map.
struct Sapling {
  StemShape stem;
  TapedStem taped;
};

// Something that a walker goes around.
struct Obstacle {
  Eigen::Vector2d xy = Eigen::Vector2d::Zero();
  double radius_m = 0;
};

struct Vegetation {
  std::vector<Sapling> saplings;
  std::vector<Obstacle> obstacles;  // shrubs, saplings and rocks; stems are not listed here
  std::vector<LowPlant> low_plants;
};

// Adds all vegetation and clutter of the forest to the scene (the stems themselves apart).
Vegetation add_vegetation(SceneModel& scene, const Forest& forest, std::uint64_t seed);

}  // namespace bole::sim
