// Keyframes of a recording for experiments with loops: followed by the odometry, or placed by the truth and then bent.
#pragma once

#include <vector>

#include "cloud/scan_frame.h"
#include "cloud/trajectory.h"
#include "slam/core/odometry/keyframes.h"
#include "slam/core/options.h"

namespace bole {

// The first `most_frames` frames, or all; every keyframe has its context. Throws Error{failure} where the track is
// lost.
std::vector<slam::Keyframe> followed_keyframes(const FrameSource& source, const slam::SlamSettings& options,
                                               std::size_t most_frames);

// The same with the poses of `truth`: what an odometry without error would hand on, and much cheaper.
std::vector<slam::Keyframe> true_keyframes(const FrameSource& source, const slam::SlamSettings& options,
                                           const Trajectory& truth, std::size_t most_frames);

// The path bent as an odometry drifts: the way slips by a share and turns at a rate that are drawn anew every 20 m.
// `share` 0.01: after 100 m one standard deviation is 1 m along the way and 1 deg of heading.
void add_drift(std::vector<slam::Keyframe>& keyframes, double share, unsigned seed);

}  // namespace bole
