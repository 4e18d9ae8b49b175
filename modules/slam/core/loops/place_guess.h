// The pose of a keyframe on an earlier stretch of the walk, to a third of a metre. A context knows a place only to the
// width of its rings, and registration needs a better guess.
#pragma once

#include "slam/core/odometry/keyframes.h"

namespace bole::slam {

struct PlaceGuess {
  Pose T_map_keyframe = Pose::Identity();
  double score = 0;  // share of the keyframe's points that fall into occupied cells of the stretch
};

// Tries shifts ahead and sideways, turns about z and a few heights around `guess` on the occupancy of the keyframes
// `first` to `last`: 3 m ahead and behind, 1 m to each side, 6 deg.
PlaceGuess place_on_stretch(const std::vector<Keyframe>& keyframes, std::size_t first, std::size_t last,
                            const Keyframe& keyframe, const Pose& guess);

}  // namespace bole::slam
