// Height and breadth of a plant by its outlines in many pictures, and points of its cloud that they refute.
#pragma once

#include "plant/core/traits/extents.h"
#include "plant/core/traits/plant_masks.h"

namespace bole::plant {

struct Outline {
  bool told = false;   // whether colours tell the plant in the pictures; else all of `points` and no sizes
  Points3 points;      // of the cloud, without those that most pictures show beside the plant
  double refuted = 0;  // share of the points that were left out
  // Outlines leave room behind them. Where enough pictures look across an extent, it is measured; else it is an upper
  // bound.
  Extent top, length, width;
  bool top_measured = false, length_measured = false, width_measured = false;
  PlanRectangle rectangle;
  // Of the plant and of what pictures show like it but nothing connects with it: a leaf whose stalk is too thin to be
  // seen, or something else.
  PointSizes with_loose;
  std::size_t views = 0;
};

// The room that nine of ten pictures leave to the plant (the visual hull: Laurentini 1994), as far as it is connected
// with the cloud and a third of its size farther. A point is refuted that fewer than half of at least five pictures
// show on the plant: clouds of depth have flying points beside edges, which lie on the plant only from where they were
// seen.
Outline measure_outline(const MaskInputs& inputs, const std::vector<std::uint32_t>& which, const Run& run);

}  // namespace bole::plant
