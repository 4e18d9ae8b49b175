#include "slam/core/inertial/inertial_filter.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>

namespace bole::slam {
namespace {

constexpr double gravity_m_s2 = 9.81, gravity_sigma = 0.03;  // between the equator and the poles
constexpr double rest_window_s = 0.5, moving_window_s = 1.0;
// At rest a hand trembles less than this.
constexpr double rest_rate_rad_s = 0.03, rest_force_m_s2 = 0.25, rest_mean_rate_rad_s = 0.06;
// Data sheets of small units allow 1 deg/s and 20 mg at the start.
constexpr double accelerometer_bias_sigma = 0.2, gyroscope_bias_sigma = 0.02, gyroscope_bias_sigma_at_rest = 0.004;
constexpr double rest_speed_sigma = 0.05, walking_speed_sigma = 1.5;
// The mean of the force over a second differs from gravity by the change of the velocity.
constexpr double moving_gravity_sigma = 0.8;
constexpr double exact_rad = 1e-6, exact_m = 1e-6;
constexpr double floor_rad = 1e-5, floor_m = 5e-5;
constexpr double found_rad = 0.01, found_m = 0.05;  // after a gap

enum Part { turn = 0, place = 3, speed = 6, gyroscope = 9, accelerometer = 12, gravity = 15 };

void set_block(Matrix18d& C, int part, double sigma) {
  C.block<3, 3>(part, part) = sigma * sigma * Eigen::Matrix3d::Identity();
}

Pose turned_and_shifted(const Pose& T, const Eigen::Vector3d& by_turn, const Eigen::Vector3d& by_shift) {
  Pose out = T;
  out.linear() = so3_exp(by_turn).toRotationMatrix() * T.linear();
  out.translation() += by_shift;
  return out;
}

Vector6d difference(const Pose& from, const Pose& to) {
  Vector6d d;
  d << so3_log(Eigen::Quaterniond(to.linear() * from.linear().transpose())), to.translation() - from.translation();
  return d;
}

}  // namespace

InertialState moved(InertialState s, const Vector18d& e) {
  s.T_map_imu = turned_and_shifted(s.T_map_imu, e.segment<3>(turn), e.segment<3>(place));
  s.velocity += e.segment<3>(speed);
  s.bias.gyroscope += e.segment<3>(gyroscope);
  s.bias.accelerometer += e.segment<3>(accelerometer);
  s.gravity += e.segment<3>(gravity);
  return s;
}

InertialState propagated(const InertialState& from, const Preintegration& by, const InertialNoise& noise,
                         Matrix18d& F) {
  const double T = by.duration_s;
  const Eigen::Matrix3d R0 = from.T_map_imu.linear();
  InertialState to = from;
  to.time_s += T;
  to.T_map_imu.linear() = Eigen::Quaterniond(R0 * by.turn).normalized().toRotationMatrix();
  to.velocity += T * from.gravity + R0 * by.velocity;
  to.T_map_imu.translation() += T * from.velocity + 0.5 * T * T * from.gravity + R0 * by.shift;
  const Eigen::Matrix3d R1 = to.T_map_imu.linear();

  F.setIdentity();
  F.block<3, 3>(turn, gyroscope) = R1 * by.turn_by_gyroscope;
  F.block<3, 3>(speed, turn) = -skew(R0 * by.velocity);
  F.block<3, 3>(speed, gyroscope) = R0 * by.velocity_by_gyroscope;
  F.block<3, 3>(speed, accelerometer) = R0 * by.velocity_by_accelerometer;
  F.block<3, 3>(speed, gravity) = T * Eigen::Matrix3d::Identity();
  F.block<3, 3>(place, turn) = -skew(R0 * by.shift);
  F.block<3, 3>(place, speed) = T * Eigen::Matrix3d::Identity();
  F.block<3, 3>(place, gyroscope) = R0 * by.shift_by_gyroscope;
  F.block<3, 3>(place, accelerometer) = R0 * by.shift_by_accelerometer;
  F.block<3, 3>(place, gravity) = 0.5 * T * T * Eigen::Matrix3d::Identity();

  // The covariance of the integration is ordered turn, velocity, shift, in the axes of end and begin.
  Eigen::Matrix<double, 18, 9> G = Eigen::Matrix<double, 18, 9>::Zero();
  G.block<3, 3>(turn, 0) = R1;
  G.block<3, 3>(speed, 3) = R0;
  G.block<3, 3>(place, 6) = R0;
  to.covariance = F * from.covariance * F.transpose() + G * by.covariance * G.transpose();
  to.covariance.block<3, 3>(gyroscope, gyroscope).diagonal().array() +=
      T * std::pow(noise.gyroscope_walk_rad_s2_sqrt_hz, 2);
  to.covariance.block<3, 3>(accelerometer, accelerometer).diagonal().array() +=
      T * std::pow(noise.accelerometer_walk_m_s3_sqrt_hz, 2);
  return to;
}

std::optional<InertialStart> InertialFilter::look(double time_s) const {
  const auto window = [&](double length_s) { return unit_.data.cover(time_s, time_s + length_s); };
  if (!window(rest_window_s)) return std::nullopt;
  Eigen::Vector3d rate = Eigen::Vector3d::Zero(), force = Eigen::Vector3d::Zero();
  double rate2 = 0, force2 = 0, weight = 0;
  unit_.data.walk(time_s, time_s + rest_window_s, [&](const Eigen::Vector3d& w, const Eigen::Vector3d& f, double dt) {
    rate += dt * w;
    force += dt * f;
    rate2 += dt * w.squaredNorm();
    force2 += dt * f.squaredNorm();
    weight += dt;
  });
  rate /= weight;
  force /= weight;
  InertialStart out;
  out.at_rest = std::sqrt(std::max(0.0, rate2 / weight - rate.squaredNorm())) < rest_rate_rad_s &&
                std::sqrt(std::max(0.0, force2 / weight - force.squaredNorm())) < rest_force_m_s2 &&
                rate.norm() < rest_mean_rate_rad_s;
  if (!out.at_rest && window(moving_window_s)) {
    // In the axes of the begin: the sensor turns meanwhile.
    const auto all = unit_.data.integrate(time_s, time_s + moving_window_s, {}, unit_.noise);
    force = all.velocity / all.duration_s;
  }
  out.gravity_in_sensor = unit_.T_sensor_imu.linear() * -force;
  return out;
}

void InertialFilter::start(double time_s, const Pose& T_map_sensor, const InertialStart& from) {
  started_ = true;
  state_ = {};
  state_.time_s = time_s;
  state_.T_map_imu = T_map_sensor * unit_.T_sensor_imu;
  state_.gravity = T_map_sensor.linear() * from.gravity_in_sensor;
  auto& C = state_.covariance;
  set_block(C, turn, exact_rad);
  set_block(C, place, exact_m);
  set_block(C, speed, from.at_rest ? rest_speed_sigma : walking_speed_sigma);
  set_block(C, gyroscope, from.at_rest ? gyroscope_bias_sigma_at_rest : gyroscope_bias_sigma);
  set_block(C, accelerometer, accelerometer_bias_sigma);
  set_block(C, gravity, from.at_rest ? 0.05 : moving_gravity_sigma);
  if (from.at_rest)
    state_.bias.gyroscope =
        so3_log(Eigen::Quaterniond(unit_.data.integrate(time_s, time_s + rest_window_s, {}, unit_.noise).turn)) /
        rest_window_s;
  // Gravity was measured with the bias of the accelerometer in it: g = -R (f - b).
  const Eigen::Matrix3d R = state_.T_map_imu.linear();
  C.block<3, 3>(gravity, gravity) += accelerometer_bias_sigma * accelerometer_bias_sigma * Eigen::Matrix3d::Identity();
  C.block<3, 3>(gravity, accelerometer) = accelerometer_bias_sigma * accelerometer_bias_sigma * R;
  C.block<3, 3>(accelerometer, gravity) = C.block<3, 3>(gravity, accelerometer).transpose();
  // Its size is known.
  Eigen::Matrix<double, 1, 18> h = Eigen::Matrix<double, 1, 18>::Zero();
  h.segment<3>(gravity) = state_.gravity.normalized().transpose();
  const double variance = h * C * h.transpose() + gravity_sigma * gravity_sigma;
  const Vector18d gain = C * h.transpose() / variance;
  C -= gain * (h * C).eval();
  const Matrix18d covariance = C;
  state_ = moved(state_, gain * (gravity_m_s2 - state_.gravity.norm()));
  state_.covariance = covariance;
}

void InertialFilter::restart(double time_s, const Pose& T_map_sensor) {
  state_.time_s = time_s;
  state_.T_map_imu = T_map_sensor * unit_.T_sensor_imu;
  state_.velocity.setZero();
  auto& C = state_.covariance;
  C.topRows<9>().setZero();
  C.leftCols<9>().setZero();
  set_block(C, turn, found_rad);
  set_block(C, place, found_m);
  set_block(C, speed, walking_speed_sigma);
}

void InertialFilter::anchor() {
  auto& C = state_.covariance;
  C.topRows<6>().setZero();
  C.leftCols<6>().setZero();
  set_block(C, turn, exact_rad);
  set_block(C, place, exact_m);
}

// From the error of the pose of the unit to that of the sensor: it sits at `lever` from the unit.
Eigen::Matrix<double, 6, 6> InertialFilter::pose_to_sensor(const Pose& T_map_imu) const {
  const Eigen::Vector3d lever = T_map_imu.linear() * unit_.T_sensor_imu.inverse().translation();
  Eigen::Matrix<double, 6, 6> J = Eigen::Matrix<double, 6, 6>::Identity();
  J.block<3, 3>(3, 0) = -skew(lever);
  return J;
}

std::optional<InertialFilter::Prediction> InertialFilter::predict(double begin_s, double end_s) const {
  constexpr double max_overlap_s = 0.02;  // of two frames
  if (!started_ || begin_s < state_.time_s - max_overlap_s || !(end_s > begin_s)) return std::nullopt;
  if (!unit_.data.cover(std::min(begin_s, state_.time_s), end_s)) return std::nullopt;
  const double from_s = std::max(begin_s, state_.time_s);
  if (!(end_s > from_s)) return std::nullopt;
  Matrix18d F;
  InertialState begin = state_;
  if (from_s > state_.time_s)
    begin = propagated(state_, unit_.data.integrate(state_.time_s, from_s, state_.bias, unit_.noise), unit_.noise, F);
  const auto over_frame = unit_.data.integrate(from_s, end_s, begin.bias, unit_.noise);
  Prediction out;
  out.state = propagated(begin, over_frame, unit_.noise, F);
  out.joint.setZero();
  out.joint.topLeftCorner<18, 18>() = out.state.covariance;
  out.joint.bottomRightCorner<6, 6>() = begin.covariance.topLeftCorner<6, 6>();
  out.joint.topRightCorner<18, 6>() = F * begin.covariance.leftCols<6>();
  out.joint.bottomLeftCorner<6, 18>() = out.joint.topRightCorner<18, 6>().transpose();
  out.to_sensor.setZero();
  out.to_sensor.block<6, 6>(0, 18) = pose_to_sensor(begin.T_map_imu);
  out.to_sensor.block<6, 6>(6, 0) = pose_to_sensor(out.state.T_map_imu);
  out.covariance = out.to_sensor * out.joint * out.to_sensor.transpose();
  // Begin and end follow each other to hundredths of a millimetre: without a floor the prior cannot be inverted.
  for (const int pose : {0, 6}) {
    out.covariance.diagonal().segment<3>(pose).array() += floor_rad * floor_rad;
    out.covariance.diagonal().segment<3>(pose + 3).array() += floor_m * floor_m;
  }

  // The poses on the way: T(s) = interpolate(begin, end, s) after(s).
  const Pose T_imu_sensor = unit_.T_sensor_imu.inverse();
  out.motion.T_map_begin = begin.T_map_imu * T_imu_sensor;
  out.motion.T_map_end = out.state.T_map_imu * T_imu_sensor;
  auto shape = std::make_shared<MotionShape>();
  Preintegration part;
  double at_s = from_s;
  for (std::size_t i = 0; i <= MotionShape::steps; ++i) {
    const double s = static_cast<double>(i) / static_cast<double>(MotionShape::steps),
                 to_s = std::min(end_s, std::max(from_s, begin_s + s * (end_s - begin_s)));
    unit_.data.walk(at_s, to_s, [&](const Eigen::Vector3d& rate, const Eigen::Vector3d& force, double dt) {
      part.add(rate - begin.bias.gyroscope, force - begin.bias.accelerometer, dt, unit_.noise);
    });
    at_s = std::max(at_s, to_s);
    const double t = part.duration_s;
    Pose T = begin.T_map_imu;
    T.linear() = begin.T_map_imu.linear() * part.turn;
    T.translation() += t * begin.velocity + 0.5 * t * t * begin.gravity + begin.T_map_imu.linear() * part.shift;
    shape->after[i] = interpolate(out.motion.T_map_begin, out.motion.T_map_end, s).inverse() * T * T_imu_sensor;
  }
  shape->after.front() = shape->after.back() = Pose::Identity();
  out.motion.shape = std::move(shape);
  return out;
}

InertialState InertialFilter::corrected(const Prediction& p, const FrameMotion& motion,
                                        const Matrix12d& information) const {
  Eigen::Matrix<double, 12, 1> found;
  found << difference(p.motion.T_map_begin, motion.T_map_begin), difference(p.motion.T_map_end, motion.T_map_end);
  const Matrix12d& prior = p.covariance;
  // (information + prior^-1)^-1 without inverting the prior, which is nearly singular.
  const Matrix12d posterior = (Matrix12d::Identity() + prior * information).partialPivLu().solve(prior);
  const Eigen::Matrix<double, 24, 12> gain = prior.ldlt().solve(p.to_sensor * p.joint).transpose();
  const Eigen::Matrix<double, 24, 1> error = gain * found;
  const Matrix24d covariance = p.joint + gain * (posterior - prior) * gain.transpose();
  InertialState out = moved(p.state, error.head<18>());
  out.covariance = 0.5 * (covariance + covariance.transpose()).topLeftCorner<18, 18>();
  return out;
}

double InertialFilter::tension(const Prediction& p, const FrameMotion& motion) {
  Eigen::Matrix<double, 12, 1> found;
  found << difference(p.motion.T_map_begin, motion.T_map_begin), difference(p.motion.T_map_end, motion.T_map_end);
  return found.dot(p.covariance.ldlt().solve(found)) / 12;
}

double InertialFilter::shift_sigma(const InertialState& state) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(state.covariance.block<3, 3>(place, place));
  return std::sqrt(std::max(0.0, solver.eigenvalues()[2]));
}

}  // namespace bole::slam
