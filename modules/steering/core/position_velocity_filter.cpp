#include "steering/core/position_velocity_filter.h"

#include <Eigen/LU>

namespace bole::steering {
namespace {

using Observation = Eigen::Matrix<double, 2, 4>;

const Observation& H() {
  static const Observation h = (Observation() << 1, 0, 0, 0, 0, 0, 1, 0).finished();
  return h;
}

}  // namespace

void PositionVelocityFilter::start(const Eigen::Vector2d& position_nav, const Eigen::Vector2d& velocity_nav,
                                   double velocity_sigma_m_s) {
  x_ << position_nav.x(), velocity_nav.x(), position_nav.y(), velocity_nav.y();
  const double r = o_.position_sigma * o_.position_sigma, v = velocity_sigma_m_s * velocity_sigma_m_s;
  P_ = Eigen::Vector4d(r, v, r, v).asDiagonal();
  without_fix_s_ = doubted_s_ = 0;
}

Eigen::Vector2d PositionVelocityFilter::position_sigma() const { return {std::sqrt(P_(0, 0)), std::sqrt(P_(2, 2))}; }

void PositionVelocityFilter::predict(double dt_s) {
  Eigen::Matrix4d A = Eigen::Matrix4d::Identity();
  A(0, 1) = A(2, 3) = dt_s;
  const double a = o_.acceleration_sigma * o_.acceleration_sigma, dt2 = dt_s * dt_s;
  Eigen::Matrix2d q;
  q << dt2 * dt2 / 4, dt2 * dt_s / 2, dt2 * dt_s / 2, dt2;
  x_ = A * x_;
  P_ = A * P_ * A.transpose();
  P_.topLeftCorner<2, 2>() += a * q;
  P_.bottomRightCorner<2, 2>() += a * q;
}

bool PositionVelocityFilter::within_gate(const Eigen::Vector2d& fix_nav) const {
  const Eigen::Matrix2d S =
      H() * P_ * H().transpose() + o_.position_sigma * o_.position_sigma * Eigen::Matrix2d::Identity();
  const Eigen::Vector2d innovation = fix_nav - position();
  return innovation.dot(S.inverse() * innovation) <= o_.gate * o_.gate;
}

void PositionVelocityFilter::update(const Eigen::Vector2d& fix_nav) {
  const Eigen::Matrix2d R = o_.position_sigma * o_.position_sigma * Eigen::Matrix2d::Identity();
  const Eigen::Matrix<double, 4, 2> K = P_ * H().transpose() * (H() * P_ * H().transpose() + R).inverse();
  x_ += K * (fix_nav - position());
  P_ = (Eigen::Matrix4d::Identity() - K * H()) * P_;
  P_ = (P_ + P_.transpose()) / 2;
}

void PositionVelocityFilter::step(double dt_s, const std::optional<Eigen::Vector2d>& fix_nav) {
  predict(dt_s);
  if (!fix_nav) {
    without_fix_s_ += dt_s;
    return;
  }
  without_fix_s_ = 0;
  if (within_gate(*fix_nav)) {
    doubted_s_ = 0;
    update(*fix_nav);
  } else if ((doubted_s_ += dt_s) > o_.patience) {
    start(*fix_nav, velocity());
    ++jumps_;
  }
}

}  // namespace bole::steering
