// The outermost points of a plant, and its height and breadth once the pictures told how far they reach.
#pragma once

#include <vector>

#include "plant/core/traits/extents.h"
#include "plant/core/traits/picture_tips.h"

namespace bole::plant {

// The top and the highest points of other parts near its height; around the plant in plan the points that reach
// farthest in each direction, and those farthest from its middle, none nearer to another than 8 mm.
std::vector<TipQuery> outermost_points(const Points3& plant, const Extents& extents);

// Height and breadth from the points moved by what the pictures show; points that no view shows stay, less the
// correction for noise. The number of points that pictures showed; fewer than half leave the extents as they were.
std::size_t correct_extents(Extents& extents, const std::vector<TipQuery>& queries, const std::vector<FoundTip>& tips);

}  // namespace bole::plant
