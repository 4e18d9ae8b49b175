// From a forest to the triangles that rays meet.
#pragma once

#include "sim/core/plot/forest.h"
#include "sim/core/plot/vegetation.h"
#include "sim/core/scene/scene_model.h"

namespace bole::sim {

struct PlotScene {
  SceneModel model;
  Vegetation vegetation;
};

PlotScene build_scene(const Forest& forest, std::uint64_t seed);

}  // namespace bole::sim
