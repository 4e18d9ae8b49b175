// How well the poses of a bundle adjustment are known.
#pragma once

#include <vector>

#include "base/no_number.h"
#include "rgbd/core/poses/bundle.h"

namespace bole::rgbd {

// Standard deviations in the worst direction, relative to what fixes the axes (board or first view). An error of the
// scale of the depth, which moves all views together, is not in them.
struct PoseSigma {
  double place = no_number;  // metres
  double turn_rad = no_number;
};

// From the normal equations with the points eliminated (Schur complement). NaN for views that take no part, and for all
// where there are more than 300.
std::vector<PoseSigma> pose_sigmas(const Bundle& bundle, int fixed_view);

}  // namespace bole::rgbd
