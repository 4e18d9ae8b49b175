// Key-frame poses that agree best with odometry and loops.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "slam/core/loops/loops.h"

namespace bole::slam {

struct PoseGraphResult {
  std::vector<Pose> T_map_keyframe;
  double initial_cost = 0, final_cost = 0;
  std::size_t doubted_loops = 0;  // loops that the robust kernel gave less than a tenth of their weight
  // By loop: 1 where it contradicts the others and the odometry so much that it must be another place. These were left
  // out of a second adjustment, which the poses come from.
  std::vector<std::uint8_t> refused;
  bool solved = true, settled = true;  // a solution was found; and within the iterations
  // What the report should warn of: an adjustment that found no solution, or broke off before it settled.
  std::vector<std::string> warnings;
};

// The first key frame stands; loops that contradict the rest are refused. Odometry edges join neighbours, loops are
// held by a Cauchy kernel. Where a quarter of the loops would be refused the odometry is believed to 5 % of
// the way in place of 1 %, and the kernel begins wide, so that many loops that agree prevail over a path that slipped.
// Where an adjustment has no solution the key frames stay where they were and all loops are refused, with a warning;
// one that did not settle within its iterations is used, with a warning. Throws Error{cancelled}.
PoseGraphResult optimise_pose_graph(const std::vector<Keyframe>& keyframes, const std::vector<Loop>& loops,
                                    const Run& run);

// The loops that were not refused.
std::vector<Loop> kept_loops(const std::vector<Loop>& loops, const PoseGraphResult& result);

}  // namespace bole::slam
