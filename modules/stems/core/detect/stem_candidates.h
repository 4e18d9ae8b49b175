// Circles of several slabs linked into stem axes.
#pragma once

#include <vector>

#include "base/run.h"
#include "stems/core/detect/slab_circles.h"

namespace bole::stems {

// A straight axis with a linear taper, through circles at several heights. Offsets from the cloud's origin, metres.
struct StemCandidate {
  double x = 0, y = 0, z = 0;       // a point of the axis
  double slope_x = 0, slope_y = 0;  // metres per metre of z
  double radius = 0, taper = 0;     // at that point; metres of radius per metre of z
  double ground_z = 0;  // z of the axis less its height above ground: ground below, by the heights of its points
  double lowest = 0, highest = 0;  // heights above ground of its circles
  double score = 0;
  int sections = 0;
  int points = 0;
  std::vector<SlabCircle> displaced;  // circles that it leaves no room for, of stems that stand here if it does not
};

struct LinkedCircles {
  std::vector<StemCandidate> stems;  // by decreasing score
  std::vector<StemCandidate> weak;   // seen in fewer than min_sections slabs, but in two at least
};

LinkedCircles link_circles(const std::vector<SlabCircle>& circles, const MeasureOptions& options, const Run& run);

}  // namespace bole::stems
