// Which motions of a frame its surroundings determine. A long corridor, a plain field or a round tank leave some of
// them open. The normal equations do not show this: noise tilts the normals of smooth surfaces and so mimics
// information along them.
#pragma once

#include <optional>
#include <string>

#include "slam/core/odometry/registration.h"

namespace bole::slam {

struct Observability {
  // Information along the weakest motion, divided by the information that the noise of normals and line directions
  // alone would give along it. About 1: there is only noise.
  double weakest = 0;
  Vector6d motion = Vector6d::Zero();  // the weakest: turn about the sensor (rad) and shift (m), map axes, of length 1

  // How evenly the surfaces face all horizontal directions: what they say of a shift along the direction that fewest of
  // them face, over that along the one that most face, each surface counting once. 1: evenly; in a corridor about 0.
  double spread = 1;
  Eigen::Vector2d unfaced_axis = Eigen::Vector2d::Zero();  // that direction, map axes

  // All six, weakest first: information over that of the noise, motions in columns and the information of the noise.
  // Empty where there are too few points.
  std::optional<Vector6d> strengths;
  Matrix6d motions = Matrix6d::Identity(), noise = Matrix6d::Identity();

  // Takes the motions that are observed less than `least` out of a motion; nothing where all are.
  std::optional<Matrix6d> determined(double least) const;

  // "a shift along (1.00, 0.00, 0.00)" or "a turn about (...)", map axes.
  std::string motion_text() const;
};

// The normal of a plane through N points with deviations s0 < s1 < s2 along its axes is tilted towards axis k with the
// variance s0^2 / (N s_k^2). The same holds for the direction of a line. Let u be the displacement of a point under a
// motion v: a plane gives the information w (n . u)^2 about v, and its noise mimics w u^T C u, with C the covariance of
// the normal. The ratio of both sums is smallest along the smallest generalised eigenvalue. Points are dealt into
// groups and the median group counts, so that a few spurious surfaces decide nothing. Thick surfaces do not count, nor
// do those seen by too few scan lines, which may move with the sensor. Zhang, Kaess and Singh 2016 (degeneracy factor)
// and Tuna et al. 2023 (X-ICP) also judge each direction by itself. Both need thresholds in units of the problem; the
// ratio to the noise does not. `met`: Registration::met of these features in these maps, or empty. Throws
// Error{cancelled}.
Observability observability(const FeatureSet& features, const FeatureMaps& maps, const FrameMotion& motion,
                            const RegistrationSettings& settings, const Run& run, std::vector<MetSurface> met = {});

}  // namespace bole::slam
