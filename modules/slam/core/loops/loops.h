// Loop closures: pairs of keyframes that see the same place after a long distance, with the relative pose from
// registration.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "slam/core/odometry/keyframes.h"
#include "slam/core/options.h"

namespace bole::slam {

struct Loop {
  std::size_t from = 0, to = 0;  // keyframes, from < to
  Pose T_from_to = Pose::Identity();
  Matrix6d information = Matrix6d::Zero();  // (turn, shift) of `to`, map axes
  double overlap = 0;
  double correction = 0;  // of the odometry
  FoundBy found_by = FoundBy::odometry;
};

struct LoopSearch {
  std::vector<Loop> loops;
  std::vector<std::pair<std::size_t, std::size_t>> refused;  // keyframes of rejected candidates
  std::size_t candidates = 0;
};

// Verifies each candidate (loop_candidates.h) by registering the keyframe against the map of the stretch around its
// partner. A loop closure needs enough overlap, no open direction and a place within loop_radius of the partner. Throws
// Error{cancelled}.
LoopSearch find_loops(const std::vector<Keyframe>& keyframes, const SlamSettings& settings, const Run& run);

}  // namespace bole::slam
