// How far a plant reaches beyond its cloud: the tips of its leaves in the pictures.
#pragma once

#include <cstdint>
#include <vector>

#include "base/run.h"
#include "cloud/core/view_source.h"
#include "plant/core/separate/point_grid.h"

namespace bole::plant {

// An outermost point of the cloud and the direction in which it is outermost (unit), in plant axes.
struct TipQuery {
  Eigen::Vector3d point = Eigen::Vector3d::Zero(), direction = Eigen::Vector3d::UnitZ();
};

struct FoundTip {
  double gain = 0;        // how far the plant reaches beyond the point along the direction; metres, may be negative
  double sd = 0;          // standard error of it, from the views
  std::size_t views = 0;  // that show it; 0: none do
  bool floater = false;   // most views show no plant at the point
};

struct TipSearch {
  double reach = 0.02;  // the farthest that is looked, metres
  double spacing = 0;   // of the cloud
};

// In each view the colours of the plant and of everything else are learnt from where the cloud lies. From the query's
// point the pixels of the plant's colours are followed outwards; a low quantile over the views in which the point is
// not hidden and the direction is seen from the side is the gain. Views in which the plant's colours go on to the end
// of the search (another leaf behind) do not vote.
std::vector<FoundTip> find_tips(const ViewSource& views, const Trajectory& poses, const Pose& T_plant_world,
                                const Points3& plant, const Points3& rest, const std::vector<TipQuery>& queries,
                                const TipSearch& search, const std::vector<std::uint32_t>& which, const Run& run);

}  // namespace bole::plant
