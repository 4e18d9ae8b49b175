// Which tree every point above the search layer belongs to.
#pragma once

#include <limits>
#include <vector>

#include "base/run.h"
#include "stems/core/tree/assign_points.h"

namespace bole::stems {

// How sure it is whose a point is: the cost of the way to it from the next best tree less that from its own, metres.
// Infinity where no other tree reaches it.
struct CrownGrowth {
  std::vector<float> lead_m;            // by point; NaN for points that growth did not label
  std::vector<std::uint8_t> by_hand{};  // by point: 1 where a person gave it to its tree. Empty: nobody did
};

// Trees grow from their stems through cells that hold points, all at once, each cell to the tree with the shortest way
// to it (Dijkstra). Ways are weighted: free along the measured stem and cheap along its continuation, upwards cheaper
// than sideways, dear through gaps. Thick stems reach further. A tree gets no point further than options.crown_radius
// from its axis. Changes labels.tree_id of the points from options.search_top above ground upwards; the axes come from
// the sections of the stem curve, so follow_stems() comes first.
CrownGrowth grow_crowns(const std::vector<Stem>& stems, const PointCloud& points, const MeasureOptions& options,
                        const Run& run, PointLabels& labels);

}  // namespace bole::stems
