// Which motions of a frame its surroundings determine. A long corridor, a plain field or a round tank leave some open;
// the normal equations do not show it, for noise tilts the normals of smooth surfaces and so feigns information along
// them.
#pragma once

#include <string>

#include "slam/core/odometry/registration.h"

namespace bole::slam {

struct Observability {
  // Information along the weakest motion over the information that the noise of normals and line directions alone would
  // give along it. About 1: there is nothing but noise.
  double weakest = 0;
  Vector6d motion = Vector6d::Zero();  // the weakest: turn about the sensor (rad) and shift (m), map axes, of length 1

  // "a shift along (1.00, 0.00, 0.00)" or "a turn about (...)", map axes.
  std::string motion_text() const;
};

// The normal of a plane through N points with deviations s0 < s1 < s2 along its axes is tilted towards axis k with the
// variance s0^2 / (N s_k^2); the same holds for the direction of a line. With u the move of a point under a motion v, a
// plane tells w (n . u)^2 about v and its noise feigns w u^T C u, C the covariance of the normal: the ratio of both
// sums is least for the least generalised eigenvalue. The points are dealt out to groups and the median group speaks,
// so that a few ghosts decide nothing. Thick surfaces are none, and those of one scan line may be
// ghosts that move with the sensor; neither counts. The idea of judging
// each direction by itself is that of Zhang, Kaess and Singh 2016 (degeneracy factor) and of Tuna et al. 2023 (X-ICP);
// both need thresholds in units of the problem, the ratio to the noise does not. Throws Error{cancelled}.
Observability observability(const FeatureSet& features, const FeatureMaps& maps, const FrameMotion& motion,
                            const RegistrationSettings& settings, const Run& run);

}  // namespace bole::slam
