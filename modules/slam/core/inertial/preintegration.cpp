#include "slam/core/inertial/preintegration.h"

#include <cmath>

namespace bole::slam {
namespace {

// Longer steps between samples are gaps: a step of a person takes half a second.
constexpr double max_step_s = 0.1;
// Scale factors of gyroscopes are off by some thousandths, which counts in fast turns.
constexpr double gyroscope_scale_sigma = 0.004;

}  // namespace

Eigen::Matrix3d right_jacobian(const Eigen::Vector3d& v) {
  const double angle2 = v.squaredNorm();
  const Eigen::Matrix3d K = skew(v);
  if (angle2 < 1e-8) return Eigen::Matrix3d::Identity() - 0.5 * K + K * K / 6;
  const double angle = std::sqrt(angle2);
  return Eigen::Matrix3d::Identity() - (1 - std::cos(angle)) / angle2 * K +
         (angle - std::sin(angle)) / (angle2 * angle) * K * K;
}

// Midpoint rule: the force of a step acts in the axes of its middle.
void Preintegration::add(const Eigen::Vector3d& rate, const Eigen::Vector3d& force, double dt,
                         const InertialNoise& noise) {
  const Eigen::Vector3d half_turn = 0.5 * dt * rate;
  const Eigen::Matrix3d to_middle = so3_exp(half_turn).toRotationMatrix(), to_end = to_middle * to_middle,
                        middle = turn * to_middle, cross = middle * skew(force);
  const Eigen::Matrix3d J_step = dt * right_jacobian(2 * half_turn),
                        middle_by_gyroscope =
                            to_middle.transpose() * turn_by_gyroscope - 0.5 * dt * right_jacobian(half_turn);
  const double half_dt2 = 0.5 * dt * dt;

  // Errors: turn (axes of the end), velocity, shift.
  Matrix9d A = Matrix9d::Identity();
  A.block<3, 3>(0, 0) = to_end.transpose();
  A.block<3, 3>(3, 0) = -dt * cross * to_middle.transpose();
  A.block<3, 3>(6, 0) = -half_dt2 * cross * to_middle.transpose();
  A.block<3, 3>(6, 3) = dt * Eigen::Matrix3d::Identity();
  Eigen::Matrix<double, 9, 3> of_force = Eigen::Matrix<double, 9, 3>::Zero();
  of_force.block<3, 3>(3, 0) = dt * middle;
  of_force.block<3, 3>(6, 0) = half_dt2 * middle;
  const double rate_variance = std::pow(noise.gyroscope_rad_s_sqrt_hz, 2) / dt,
               force_variance = std::pow(noise.accelerometer_m_s2_sqrt_hz, 2) / dt;
  covariance = A * covariance * A.transpose() + force_variance * of_force * of_force.transpose();
  covariance.topLeftCorner<3, 3>() += rate_variance * J_step * J_step.transpose();

  shift += dt * velocity + half_dt2 * (middle * force);
  shift_by_gyroscope += dt * velocity_by_gyroscope - half_dt2 * cross * middle_by_gyroscope;
  shift_by_accelerometer += dt * velocity_by_accelerometer - half_dt2 * middle;
  velocity += dt * (middle * force);
  velocity_by_gyroscope -= dt * cross * middle_by_gyroscope;
  velocity_by_accelerometer -= dt * middle;
  turn_by_gyroscope = to_end.transpose() * turn_by_gyroscope - J_step;
  turn = turn * to_end;
  duration_s += dt;
}

InertialMeasurements::InertialMeasurements(const InertialRecord& record, double time_offset_s)
    : samples_(record.samples) {
  for (auto& s : samples_) s.time_s -= time_offset_s;
}

bool InertialMeasurements::cover(double begin_s, double end_s) const {
  if (samples_.size() < 2 || !(begin_s >= samples_.front().time_s) || !(end_s <= samples_.back().time_s)) return false;
  auto next = std::ranges::upper_bound(samples_, begin_s, {}, &InertialSample::time_s);
  for (; next != samples_.end(); ++next) {
    if (next->time_s - (next - 1)->time_s > max_step_s) return false;
    if (next->time_s >= end_s) break;
  }
  return true;
}

InertialSample InertialMeasurements::at(double time_s) const {
  auto next = std::ranges::upper_bound(samples_, time_s, {}, &InertialSample::time_s);
  next = std::clamp(next, samples_.begin() + 1, samples_.end() - 1);
  const auto &a = *(next - 1), &b = *next;
  const double u = std::clamp((time_s - a.time_s) / (b.time_s - a.time_s), 0.0, 1.0);
  return {time_s, (1 - u) * a.angular_rate_rad_s + u * b.angular_rate_rad_s,
          (1 - u) * a.specific_force_m_s2 + u * b.specific_force_m_s2};
}

Preintegration InertialMeasurements::integrate(double begin_s, double end_s, const InertialBias& bias,
                                               const InertialNoise& noise) const {
  Preintegration out;
  walk(begin_s, end_s, [&](const Eigen::Vector3d& rate, const Eigen::Vector3d& force, double dt) {
    out.add(rate - bias.gyroscope, force - bias.accelerometer, dt, noise);
  });
  const Eigen::Vector3d turned = gyroscope_scale_sigma * so3_log(Eigen::Quaterniond(out.turn));
  out.covariance.topLeftCorner<3, 3>() += turned * turned.transpose();
  return out;
}

}  // namespace bole::slam
