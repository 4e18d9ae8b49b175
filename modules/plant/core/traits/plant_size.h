// Height and breadth of a plant with their 95 % intervals, by its cloud and by the pictures.
#pragma once

#include "base/report.h"
#include "plant/core/separate/plant_scene.h"
#include "plant/core/traits/extents.h"
#include "plant/core/traits/trait_tables.h"
#include "plant/core/traits/traits.h"

namespace bole::plant {

struct SizeInputs {
  const TraitInputs& data;
  const TraitOptions& options;
  const PlantScene& scene;
  const Pose& T_plant_world;
  const Points3 &plant, &solid, &others;  // plant axes; solid: everything but floaters; others: that without the plant
  const std::vector<std::uint32_t>& views;  // that are looked at; all have a pose
};

struct PlantSize {
  Interval height, length, width;  // high is NaN where the plant is cut off
  Extents extents;
  bool outline_told = false;  // whether pictures have told what the cloud lacks
};

// Finds in `report`: plant_cut_off, cloud_and_pictures_differ, loose_parts_in_pictures.
PlantSize measure_plant_size(const SizeInputs& inputs, Report& report, const Run& run);

// The 95 % interval of a length whose scale is known to `scale_sd` percent.
Interval interval_of(double value, double sd, double scale_sd, double freedom = 1e6);

}  // namespace bole::plant
