// Key-frame poses that agree best with odometry and loops.
#pragma once

#include <vector>

#include "slam/core/loops.h"

namespace bole {

struct PoseGraphResult {
  std::vector<Pose> T_map_keyframe;
  double initial_cost = 0, final_cost = 0;
  std::size_t doubted_loops = 0;  // loops that the robust kernel gave less than a tenth of their weight
};

// The first key frame stands. Odometry edges join neighbours, loops are held by a Cauchy kernel. Throws
// Error{cancelled}.
PoseGraphResult optimise_pose_graph(const std::vector<Keyframe>& keyframes, const std::vector<Loop>& loops,
                                    const Run& run);

}  // namespace bole
