// Revisits: pairs of key frames that see the same place after a long way, with the relative pose that registration
// gives.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "slam/core/odometry/keyframes.h"
#include "slam/core/options.h"

namespace bole::slam {

struct Loop {
  std::size_t from = 0, to = 0;  // key frames, from < to
  Pose T_from_to = Pose::Identity();
  Matrix6d information = Matrix6d::Zero();  // (turn, shift) of `to`, map axes
  double overlap = 0;
  double correction_m = 0;  // against the odometry
  std::string found_by;     // "odometry" or "context"
};

struct LoopSearch {
  std::vector<Loop> loops;
  std::vector<std::pair<std::size_t, std::size_t>> refused;  // key frames of candidates that did not hold
  std::size_t candidates = 0;
};

// Each candidate (loop_candidates.h) is verified by registering the key frame against the map of the stretch about its
// partner; enough overlap, no open direction and a place within loop_radius of the partner make it a loop. Throws
// Error{cancelled}.
LoopSearch find_loops(const std::vector<Keyframe>& keyframes, const SlamOptions& options, const Run& run);

}  // namespace bole::slam
