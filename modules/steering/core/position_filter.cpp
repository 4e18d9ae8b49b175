#include "steering/core/position_filter.h"

#include <cmath>

namespace bole::steering {

void PositionFilter::predict(double dt) {
  age_s_ += dt;
  if (!started_) return;
  Eigen::Matrix2d A;
  A << 1, dt, 0, 1;
  const double q = o_.acceleration_sigma * o_.acceleration_sigma;
  Eigen::Matrix2d Q;
  Q << dt * dt * dt * dt / 4, dt * dt * dt / 2, dt * dt * dt / 2, dt * dt;
  for (auto& a : axis_) a.state = A * a.state, a.P = A * a.P * A.transpose() + q * Q;
}

bool PositionFilter::update(const Eigen::Vector2d& z, const Eigen::Vector2d& velocity) {
  const double R = o_.position_sigma * o_.position_sigma;
  bool fits = started_;
  for (int i = 0; i < 2 && fits && o_.gate > 0; ++i)
    fits = std::abs(z[i] - axis_[i].state[0]) <= o_.gate * std::sqrt(axis_[i].P(0, 0) + R);
  if (started_ && !fits && age_s_ < o_.patience) return false;
  if (!fits) {
    for (int i = 0; i < 2; ++i) {
      const double v = started_ ? axis_[i].state[1] : velocity[i];
      axis_[i].state = {z[i], v};
      axis_[i].P << R, 0, 0, 0.25;
    }
    started_ = true, age_s_ = 0;
    return true;
  }
  for (int i = 0; i < 2; ++i) {
    auto& a = axis_[i];
    const Eigen::Vector2d K = a.P.col(0) / (a.P(0, 0) + R);
    a.state += K * (z[i] - a.state[0]);
    Eigen::Matrix2d I_KH = Eigen::Matrix2d::Identity();
    I_KH.col(0) -= K;
    a.P = I_KH * a.P;
    a.P = 0.5 * (a.P + a.P.transpose().eval());
  }
  age_s_ = 0;
  return true;
}

double PositionFilter::sigma_m() const { return std::sqrt(std::max(axis_[0].P(0, 0), axis_[1].P(0, 0))); }

}  // namespace bole::steering
