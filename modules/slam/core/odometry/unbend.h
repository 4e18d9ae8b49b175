// Frames that did not move as it was assumed when they were de-skewed.
#pragma once

#include "slam/core/odometry/registration.h"

namespace bole::slam {

// How much the turn within a frame differs between two motions.
double bend_rad(const FrameMotion& assumed, const FrameMotion& found);

// Begin and end pose of a frame that was not elastic until now. A rigid frame that turned otherwise than it was assumed
// is bent, settles where it agrees with its own bend, and bends the map: in a hairpin at 213 deg/s a path got 93 deg
// wrong while two thirds of the points agreed. So the motion is fitted to the points, held to `assumed` by what a
// carrier can do within a frame, from far enough off that a prediction that is wrong by 10 deg is put right. Throws
// Error{cancelled}.
Registration register_bent(const FeatureSet& features, const FeatureMaps& maps, const FrameMotion& assumed,
                           RegistrationSettings settings, const Run& run);

}  // namespace bole::slam
