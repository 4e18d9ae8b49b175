// The axis of a stem at any height, also above the part that was measured.
#pragma once

#include <Eigen/Core>
#include <algorithm>

#include "stems/core/fit/fit_stem.h"

namespace bole::stems {

inline constexpr double max_slope_above = 0.15;  // above the measured stem a lean is followed no further than this
inline constexpr double tallest_m = 80;

// Straight over the measured part, less inclined above.
struct TreeAxis {
  explicit TreeAxis(const Stem& s)
      : stem(&s),
        breast_height(s.breast_height),
        slope(s.direction.head<2>() / s.direction.z()),
        bend_z(s.breast_height.z() + 3),
        radius(s.radius) {
    above = slope;
    if (above.norm() > max_slope_above) above *= max_slope_above / above.norm();
  }
  Eigen::Vector2d at(double z) const {
    const double low = std::min(z, bend_z) - breast_height.z(), high = std::max(0.0, z - bend_z);
    return breast_height.head<2>() + low * slope + high * above;
  }
  const Stem* stem;
  Eigen::Vector3d breast_height;  // here, and not looked up in the stem: every point of the cloud asks for it
  Eigen::Vector2d slope, above;
  double bend_z, radius;
};

}  // namespace bole::stems
