// From a forest to the triangles that rays meet.
#pragma once

#include "sim/core/forest.h"
#include "sim/core/scene_model.h"
#include "sim/core/vegetation.h"

namespace bole::sim {

struct PlotScene {
  SceneModel model;
  Vegetation vegetation;
};

PlotScene build_scene(const Forest& forest, std::uint64_t seed);

}  // namespace bole::sim
