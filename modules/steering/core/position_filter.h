// Position-velocity Kalman filter (SPEC E3, eqs. 6 to 16).
#pragma once

#include <Eigen/Core>
#include <optional>

#include "steering/core/steering_options.h"

namespace bole::steering {

// State [x vx y vy], constant velocity, observation of the position, R diagonal. Q is that of white acceleration. The
// axes do not mix, so each is a filter of its own.
class PositionFilter {
 public:
  explicit PositionFilter(const FilterOptions& options) : o_(options) {}

  bool started() const { return started_; }
  // To the time of the next observation or control step.
  void predict(double dt_s);
  // False when the observation is further off than the gate and was not used. `velocity`: for a first start, m/s.
  bool update(const Eigen::Vector2d& position, const Eigen::Vector2d& velocity = Eigen::Vector2d::Zero());

  Eigen::Vector2d position() const { return {axis_[0].state[0], axis_[1].state[0]}; }
  Eigen::Vector2d velocity() const { return {axis_[0].state[1], axis_[1].state[1]}; }
  double sigma_m() const;                  // of the position, larger axis
  double age_s() const { return age_s_; }  // since the last observation that was used

 private:
  struct AxisState {
    Eigen::Vector2d state = Eigen::Vector2d::Zero();
    Eigen::Matrix2d P = Eigen::Matrix2d::Zero();
  };
  FilterOptions o_;
  AxisState axis_[2];
  bool started_ = false;
  double age_s_ = 0;
};

}  // namespace bole::steering
