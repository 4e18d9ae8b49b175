// From fixes of an antenna to the control point: lever arm and position-velocity filter (SPEC E2, E3). The simulated
// drive and recorded tracks go through it alike.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "geo/core/attitude.h"
#include "steering/core/position_velocity_filter.h"

namespace bole::steering {

struct NavigatedPoint {
  std::optional<Eigen::Vector2d> received;             // the fix alone, brought to the control point
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  // filtered
};

class Navigator {
 public:
  // `lever_arm_body`: from the control point (middle of the rear axle on the ground) to the antenna; forward, left, up.
  Navigator(const FilterOptions& filter, const Eigen::Vector3d& lever_arm_body)
      : filter_(filter), lever_arm_body_(lever_arm_body) {}

  void start(const Eigen::Vector2d& control_point_nav, const Eigen::Vector2d& velocity_nav,
             double velocity_sigma_m_s = 1) {
    filter_.start(control_point_nav, velocity_nav, velocity_sigma_m_s);
  }

  // Where the control point is by one fix alone.
  Eigen::Vector2d reduced(const Eigen::Vector3d& antenna_nav, const geo::Attitude& attitude) const;

  // One interval. Without a fix the position goes on with the speed of the wheels along the heading, where that speed
  // is known, else with the last velocity.
  NavigatedPoint step(double dt_s, const std::optional<Eigen::Vector3d>& antenna_nav, const geo::Attitude& attitude,
                      std::optional<double> wheel_speed_m_s = std::nullopt);

  PositionVelocityFilter& filter() { return filter_; }
  const PositionVelocityFilter& filter() const { return filter_; }
  const Eigen::Vector3d& lever_arm_body() const { return lever_arm_body_; }

 private:
  PositionVelocityFilter filter_;
  Eigen::Vector3d lever_arm_body_;
};

}  // namespace bole::steering
