#include "geo/core/attitude.h"

#include <cmath>
#include <numbers>

#include "base/transform.h"

namespace bole::geo {

using std::numbers::pi;

Eigen::Matrix3d Attitude::R_nav_body() const { return rotation_from_rpy(roll_rad, pitch_rad, yaw_rad); }

Eigen::Vector3d control_point(const Eigen::Vector3d& antenna_nav, const Attitude& attitude,
                              const Eigen::Vector3d& lever_arm_body) {
  return antenna_nav - attitude.R_nav_body() * lever_arm_body;
}

double bearing_from_yaw_rad(double yaw_rad) {
  const double bearing = std::remainder(pi / 2 - yaw_rad, 2 * pi);
  return bearing < 0 ? bearing + 2 * pi : bearing;
}

double yaw_from_bearing_rad(double bearing_rad) {
  const double yaw = std::remainder(pi / 2 - bearing_rad, 2 * pi);
  return yaw <= -pi ? yaw + 2 * pi : yaw;
}

}  // namespace bole::geo
