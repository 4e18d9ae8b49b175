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
  bool by_hand = false;  // a person answers for it: it is never refused and has no robust kernel
};

// A candidate, whether it became a loop, and if not, why.
struct CheckedLoop {
  Loop loop;
  bool accepted = false;
  std::string reason;                // empty where accepted
  double score = 0;                  // see LoopCandidate
  double rms = 0, conditioning = 0;  // see Registration
};

struct LoopSearch {
  std::vector<Loop> loops;
  std::vector<CheckedLoop> checked;                          // all candidates in the order of the walk
  std::vector<std::pair<std::size_t, std::size_t>> refused;  // keyframes of rejected candidates
  std::size_t candidates = 0;
};

// Verifies each candidate (loop_candidates.h) by registering the keyframe against the map of the stretch around its
// partner. With LoopAcceptance::overlap a loop closure needs enough overlap, no open direction and a place within
// loop_radius of the partner. With LoopAcceptance::distance (SPEC D) the contexts have decided: the registration must
// converge, with closest points within loop_fitness (Shan and Englot 2018). Throws Error{cancelled}.
LoopSearch find_loops(const std::vector<Keyframe>& keyframes, const SlamSettings& settings, const Run& run);

}  // namespace bole::slam
