#include "steering/core/navigator.h"

#include <cmath>

namespace bole::steering {

Eigen::Vector2d Navigator::reduced(const Eigen::Vector3d& antenna_nav, const geo::Attitude& attitude) const {
  return geo::control_point(antenna_nav, attitude, lever_arm_body_).head<2>();
}

NavigatedPoint Navigator::step(double dt_s, const std::optional<Eigen::Vector3d>& antenna_nav,
                               const geo::Attitude& attitude, std::optional<double> wheel_speed_m_s) {
  NavigatedPoint point;
  if (antenna_nav)
    point.received = reduced(*antenna_nav, attitude);
  else if (wheel_speed_m_s)
    filter_.set_velocity(*wheel_speed_m_s * Eigen::Vector2d(std::cos(attitude.yaw_rad), std::sin(attitude.yaw_rad)));
  filter_.step(dt_s, point.received);
  point.position = filter_.position();
  return point;
}

}  // namespace bole::steering
