// Objects that stand above the ground all round: buildings, crowns.
#pragma once

#include <vector>

#include "ground/core/low_points.h"

namespace bole::ground {

struct RaisedLimits {
  double step_m = 1.0;          // an object stands at least this high above what is beside it
  double join_slope_tan = 0.7;  // candidates that rise less steeply than this belong together
  double roughness_m = 0.2;
  double max_area_m2 = 20000;  // larger ones are terrain: plateaus, terraces
};

// 1 for each candidate of a group of adjacent candidates whose rim falls off nearly everywhere. Unlike the lowest point
// of a seed cell this does not depend on how large an object is. Groups that lean on the terrain on one side (terraces,
// ramps, bridges) are not raised.
std::vector<char> raised_objects(const std::vector<LowPoint>& candidates, const GridShape& shape,
                                 const RaisedLimits& limits, const Run& run);

}  // namespace bole::ground
