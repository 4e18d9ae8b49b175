// The position-velocity Kalman filter of SPEC E3.
#pragma once

#include <Eigen/Core>
#include <optional>

#include "steering/core/drive_options.h"

namespace bole::steering {

// State [x vx y vy] in navigation axes, metres and seconds; constant velocity with white acceleration; observed is the
// position, with a diagonal covariance (the printed (12) lacks the minus of the prior, and its A the time step). A fix
// that leaves the gate is left out until `patience` is over: then it is a new place, and the position starts there.
class PositionVelocityFilter {
 public:
  explicit PositionVelocityFilter(const FilterOptions& options) : o_(options) {}

  void start(const Eigen::Vector2d& position_nav, const Eigen::Vector2d& velocity_nav, double velocity_sigma_m_s = 1);
  // One step of dt_s; without a fix it only predicts.
  void step(double dt_s, const std::optional<Eigen::Vector2d>& fix_nav);

  // Standard deviation of the fixes to come, per axis, where it is not that of the options.
  void set_position_sigma(double sigma_m) { o_.position_sigma = sigma_m; }

  // Dead reckoning: what wheels and heading say in place of the last velocity, for the time without fixes.
  void set_velocity(const Eigen::Vector2d& velocity_nav) {
    x_(1) = velocity_nav.x();
    x_(3) = velocity_nav.y();
  }

  Eigen::Vector2d position() const { return {x_(0), x_(2)}; }
  Eigen::Vector2d velocity() const { return {x_(1), x_(3)}; }
  Eigen::Vector2d position_sigma() const;
  double seconds_without_fix() const { return without_fix_s_; }  // that was believed or doubted
  bool doubts() const { return doubted_s_ > 0; }
  int jumps() const { return jumps_; }  // how often it began anew where the fixes stayed

 private:
  void predict(double dt_s);
  void update(const Eigen::Vector2d& fix_nav);
  bool within_gate(const Eigen::Vector2d& fix_nav) const;
  FilterOptions o_;
  Eigen::Vector4d x_ = Eigen::Vector4d::Zero();
  Eigen::Matrix4d P_ = Eigen::Matrix4d::Identity();
  double without_fix_s_ = 0, doubted_s_ = 0;
  int jumps_ = 0;
};

}  // namespace bole::steering
