// Where a key frame lies on an earlier stretch of the walk, to a third of a metre: what looks alike is near, but a
// context knows a place to the width of its rings only, and registration wants better.
#pragma once

#include "slam/core/odometry/keyframes.h"

namespace bole::slam {

struct PlaceGuess {
  Pose T_map_keyframe = Pose::Identity();
  double score = 0;  // share of the key frame's points that fall into cells that the stretch has taken
};

// Tries shifts ahead and aside, turns about z and a few heights about `guess` on the occupancy of the key frames
// `first` to `last`: 3 m ahead and astern, 1 m aside, 6 deg.
PlaceGuess place_on_stretch(const std::vector<Keyframe>& keyframes, std::size_t first, std::size_t last,
                            const Keyframe& keyframe, const Pose& guess);

}  // namespace bole::slam
