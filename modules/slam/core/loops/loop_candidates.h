// Where to look for revisits: which earlier key frames may show the place of a later one, and where that would put it.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/run.h"
#include "slam/core/odometry/keyframes.h"
#include "slam/core/options.h"

namespace bole::slam {

// A key frame, and where a revisit would put it.
struct LoopCandidate {
  std::size_t from = 0, to = 0;
  Pose T_map_to = Pose::Identity();
  double most_correction_m = 0;  // against the odometry
  std::string found_by;          // "odometry" or "context"
};

// First and last key frame of the stretch about `from` that `to` is held against.
std::pair<std::size_t, std::size_t> stretch_about(const std::vector<Keyframe>& keyframes, std::size_t from,
                                                  std::size_t to);

// A key frame every 1.5 m of the way is asked, in turn, against those at least loop_path before it. By odometry: the
// nearest in the estimated path, within loop_radius. By context, no farther off than the odometry may have drifted (3 m
// and loop_drift of the way between), as the option context_search says:
// "single" (Kim and Kim 2018, SPEC D): of the nearest ring keys the context that is most alike; the guess is its pose,
// turned.
// "placed": the three most alike (with loops "both" by cart context as well), each laid on the occupancy of its stretch
// (place_guess.h), and the best fit taken.
// "sequence": rows of one kind look alike wherever one stands, so the odometry and the way speak as well. All places
// and headings that it can have drifted to are compared, and none else, and the distance is the mean over the key frame
// and those before it, each held against the place where it would have been (Milford and Wyeth 2012 compare sequences
// of pictures so). Then as "placed".
// Throws Error{cancelled}.
std::vector<LoopCandidate> find_loop_candidates(const std::vector<Keyframe>& keyframes, const SlamOptions& options,
                                                const Run& run);

}  // namespace bole::slam
