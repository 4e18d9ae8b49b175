#include "features/clouds/cloud_align.h"

#include <cmath>

#include "base/angles.h"

namespace bole::desktop {
namespace {

constexpr double upright = 1 - 1e-12;  // sine of a tilt at which turn and the other tilt are one motion

}  // namespace

// R = Rz(turn) Ry(tilt_y) Rx(tilt_x).
CloudPlacing placed_after(const CloudEntry& cloud, const alignment::Similarity& motion) {
  const auto before = cloud.place();
  const Eigen::Matrix3d R = motion.turn * before.turn();
  CloudPlacing after;
  after.scale = motion.scale * cloud.at.scale;
  after.shift_m = motion.of(before.of(before.pivot)) - before.pivot;
  after.tilt_y_deg = degrees(std::asin(std::clamp(-R(2, 0), -1.0, 1.0)));
  if (std::abs(R(2, 0)) < upright) {
    after.tilt_x_deg = degrees(std::atan2(R(2, 1), R(2, 2)));
    after.turn_deg = degrees(std::atan2(R(1, 0), R(0, 0)));
  } else {
    after.turn_deg = degrees(std::atan2(-R(0, 1), R(1, 1)));
  }
  return after;
}

}  // namespace bole::desktop
