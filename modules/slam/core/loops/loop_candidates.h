// Candidates for loop closures: which earlier keyframes may show the place of a later one, and its pose there.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/run.h"
#include "slam/core/odometry/keyframes.h"
#include "slam/core/options.h"

namespace bole::slam {

// A pair of keyframes, and the pose of the later one if they show the same place.
struct LoopCandidate {
  std::size_t from = 0, to = 0;
  Pose T_map_to = Pose::Identity();
  double max_correction = 0;  // of the odometry
  FoundBy found_by = FoundBy::odometry;
  double score = 0;  // by odometry: metres between the two; by context: the distance of the contexts
};

// First and last keyframe of the stretch (settings.loop_stretch) around `from` that `to` is compared with.
std::pair<std::size_t, std::size_t> stretch_about(const std::vector<Keyframe>& keyframes, std::size_t from,
                                                  std::size_t to, const SlamSettings& settings);

// Tries a keyframe every 1.5 m against those at least loop_path before it. By odometry: the nearest one on the
// estimated trajectory within loop_radius. By context: no farther away than the odometry can have drifted (3 m plus
// loop_drift of the distance travelled between them), as settings.context_search says:
// `single` (Kim and Kim 2018, SPEC D): the most similar context of the nearest ring keys. The guess is its pose,
// rotated. With LoopAcceptance::distance the odometry does not count.
// `placed`: the three most similar (with LoopSource::both also by cart context). Each is aligned with the occupancy of
// its stretch (place_guess.h), and the best fit is taken.
// `sequence`: rows of one kind look similar everywhere, so odometry and earlier keyframes count as well. All places and
// headings within the drift are compared, and no others. The distance is the mean over the keyframe and those before
// it, each compared with the place where it would have been (Milford and Wyeth 2012 compare sequences of images in this
// way). Then as `placed`.
// Throws Error{cancelled}.
std::vector<LoopCandidate> find_loop_candidates(const std::vector<Keyframe>& keyframes, const SlamSettings& options,
                                                const Run& run);

}  // namespace bole::slam
