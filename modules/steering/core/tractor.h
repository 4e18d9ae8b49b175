// A tractor as a bicycle: rear axle middle, front wheels that turn with lag and limits, slip on slopes.
#pragma once

#include <Eigen/Core>
#include <deque>

#include "base/random.h"
#include "geo/core/attitude.h"
#include "steering/core/drive_options.h"

namespace bole::steering {

class Tractor {
 public:
  // `slope_yaw_rad`: the direction along the slope whose right side falls (the line from A to B).
  Tractor(const TractorOptions& options, double slope_yaw_rad, std::uint64_t seed);

  void place(const Eigen::Vector2d& rear_axle_nav, double yaw_rad, double speed_m_s);
  // Drives for dt_s with a wheel angle asked for and a speed to reach (at 0.7 m/s2).
  void advance(double dt_s, double wheel_command_rad, double speed_m_s);

  const Eigen::Vector2d& rear_axle() const { return position_; }  // middle of the rear axle on the ground
  double speed_m_s() const { return speed_; }
  double wheel_rad() const { return wheel_; }
  geo::Attitude attitude() const;

 private:
  void turn_wheels(double dt_s, double command_rad);
  void shake(double way_m);
  TractorOptions o_;
  double slope_yaw_rad_;
  Random random_;
  Eigen::Vector2d position_ = Eigen::Vector2d::Zero();
  double yaw_ = 0, speed_ = 0, wheel_ = 0;
  double rough_roll_ = 0, rough_pitch_ = 0, rough_wheel_ = 0;
  std::deque<double> commands_;  // one per sub-step, the oldest first
};

}  // namespace bole::steering
