// Frames that did not move as assumed when they were de-skewed.
#pragma once

#include "slam/core/odometry/registration.h"

namespace bole::slam {

// How much the rotation within a frame differs between two motions.
double bend_rad(const FrameMotion& assumed, const FrameMotion& found);

// Fits begin and end pose of a frame that was registered rigidly. A rigid frame whose rotation differs from the assumed
// one is bent, converges where it agrees with its own bend, and bends the map: in a hairpin at 213 deg/s a trajectory
// became wrong by 93 deg while two thirds of the points agreed. So the motion is fitted to the points, with `assumed`
// as a prior of what a carrier can do within a frame, wide enough to correct a prediction that is wrong by 10 deg.
// Throws Error{cancelled}.
Registration register_bent(const FeatureSet& features, const FeatureMaps& maps, const FrameMotion& assumed,
                           RegistrationSettings settings, const Run& run);

}  // namespace bole::slam
