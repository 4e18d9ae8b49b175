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
// The mean of the force over a second differs from gravity by the change of the velocity; in steady motion by the turn
// of the velocity alone.
constexpr double moving_gravity_sigma = 0.8, steady_gravity_sigma = 0.15, rest_gravity_sigma = 0.05;
// Errors of frames follow each other, so that the standard deviations of a mount are somewhat too small.
constexpr double mount_sigmas = 2;
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

// From the error of the pose of the unit to that of the sensor: it sits at `lever` from the unit.
Matrix6d pose_to_sensor(const InertialState& s) {
  const Eigen::Vector3d lever = s.T_map_imu.linear() * s.T_sensor_imu.inverse().translation();
  Matrix6d J = Matrix6d::Identity();
  J.block<3, 3>(3, 0) = -skew(lever);
  return J;
}

// From the error of the mount to that of the pose of the sensor.
MatrixPoseMount mount_to_sensor(const InertialState& s) {
  const Eigen::Matrix3d R = s.T_map_imu.linear(), R_map_sensor = R * s.T_sensor_imu.linear().transpose(),
                        arm = skew(R_map_sensor * s.T_sensor_imu.translation());
  const Eigen::Vector3d rate = R * s.rate_rad_s;
  MatrixPoseMount J;
  J << -R, Eigen::Matrix3d::Zero(), rate, -arm * R, -R_map_sensor, s.velocity + arm * rate;
  return J;
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
  to.with_mount = F * from.with_mount;
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
  out.steady = std::sqrt(std::max(0.0, rate2 / weight - rate.squaredNorm())) < rest_rate_rad_s &&
               std::sqrt(std::max(0.0, force2 / weight - force.squaredNorm())) < rest_force_m_s2 &&
               rate.norm() < rest_mean_rate_rad_s;
  out.at_rest = out.steady;
  if (!out.steady && window(moving_window_s)) {
    // In the axes of the begin: the sensor turns meanwhile.
    const auto all = unit_.data.integrate(time_s, time_s + moving_window_s, {}, unit_.noise);
    force = all.velocity / all.duration_s;
  }
  out.gravity_in_sensor = unit_.T_sensor_imu.linear() * -force;
  return out;
}

// The sensor is where it is to these standard deviations. Where the unit is follows from its mount.
void InertialFilter::place_sensor(double sigma_rad, double sigma) {
  Matrix6d of_sensor = Matrix6d::Zero();
  of_sensor.diagonal() << Eigen::Vector3d::Constant(sigma_rad * sigma_rad), Eigen::Vector3d::Constant(sigma * sigma);
  const Matrix6d from_sensor = pose_to_sensor(state_).inverse();
  const MatrixPoseMount J = mount_to_sensor(state_);
  auto& C = state_.covariance;
  C.topRows<6>().setZero();
  C.leftCols<6>().setZero();
  C.topLeftCorner<6, 6>() =
      from_sensor * (of_sensor + J * state_.mount_covariance * J.transpose()) * from_sensor.transpose();
  // Its pose has to do with the rest of the state through the mount alone.
  state_.with_mount.topRows<6>() = -from_sensor * J * state_.mount_covariance;
  C.topRightCorner<6, 12>() = -from_sensor * J * state_.with_mount.bottomRows<12>().transpose();
  C.bottomLeftCorner<12, 6>() = C.topRightCorner<6, 12>().transpose();
}

// The mount is left as it is and its share kept (Schmidt 1966).
template <int Rows>
void InertialFilter::observe(const Eigen::Matrix<double, Rows, 18>& H, const Eigen::Matrix<double, Rows, 1>& residual,
                             const Eigen::Matrix<double, Rows, 1>& sigmas) {
  const Matrix18d& C = state_.covariance;
  Eigen::Matrix<double, Rows, Rows> S = H * C * H.transpose();
  S.diagonal() += sigmas.cwiseAbs2();
  const Eigen::Matrix<double, 18, Rows> gain = C * H.transpose() * S.inverse();
  const Matrix18d kept = Matrix18d::Identity() - gain * H;
  Matrix18d after = kept * C * kept.transpose();
  after += gain * sigmas.cwiseAbs2().asDiagonal() * gain.transpose();
  state_ = moved(state_, gain * residual);
  state_.covariance = 0.5 * (after + after.transpose());
  state_.with_mount = (kept * state_.with_mount).eval();
}

void InertialFilter::start(double time_s, const Pose& T_map_sensor, const InertialStart& from) {
  started_ = true;
  state_ = {};
  state_.time_s = time_s;
  state_.T_sensor_imu = unit_.T_sensor_imu;
  state_.T_map_imu = T_map_sensor * unit_.T_sensor_imu;
  state_.gravity = T_map_sensor.linear() * from.gravity_in_sensor;
  if (const auto& s = unit_.mount_sigmas) {
    Eigen::Matrix<double, 7, 1> sigma;
    sigma << Eigen::Vector3d::Constant(s->turn_rad), Eigen::Vector3d::Constant(s->lever), s->time_s;
    state_.mount_covariance.diagonal() = (mount_sigmas * sigma).cwiseAbs2();
  }
  auto& C = state_.covariance;
  set_block(C, speed, walking_speed_sigma);
  set_block(C, gyroscope, gyroscope_bias_sigma);
  set_block(C, accelerometer, accelerometer_bias_sigma);
  set_block(C, gravity, from.at_rest ? rest_gravity_sigma : from.steady ? steady_gravity_sigma : moving_gravity_sigma);
  // Gravity was measured with the bias of the accelerometer in it: g = -R (f - b).
  const Eigen::Matrix3d R = state_.T_map_imu.linear();
  C.block<3, 3>(gravity, gravity) += accelerometer_bias_sigma * accelerometer_bias_sigma * Eigen::Matrix3d::Identity();
  C.block<3, 3>(gravity, accelerometer) = accelerometer_bias_sigma * accelerometer_bias_sigma * R;
  C.block<3, 3>(accelerometer, gravity) = C.block<3, 3>(gravity, accelerometer).transpose();
  place_sensor(exact_rad, exact_m);
  // And through the turn of the unit.
  Matrix18d by_turn = Matrix18d::Identity();
  by_turn.block<3, 3>(gravity, turn) = -skew(state_.gravity);
  C = (by_turn * C * by_turn.transpose()).eval();
  state_.with_mount = (by_turn * state_.with_mount).eval();
  // Its size is known.
  Eigen::Matrix<double, 1, 18> h = Eigen::Matrix<double, 1, 18>::Zero();
  h.segment<3>(gravity) = state_.gravity.normalized().transpose();
  observe<1>(h, Eigen::Matrix<double, 1, 1>(gravity_m_s2 - state_.gravity.norm()),
             Eigen::Matrix<double, 1, 1>(gravity_sigma));
  if (from.at_rest) hold_still(time_s);
}

void InertialFilter::hold_still(double since_s) {
  const double until_s = since_s + rest_window_s;
  if (!unit_.data.cover(since_s + state_.later_s, until_s + state_.later_s)) return;
  const auto over = unit_.data.integrate(since_s + state_.later_s, until_s + state_.later_s, {}, unit_.noise);
  Eigen::Matrix<double, 6, 18> H = Eigen::Matrix<double, 6, 18>::Zero();
  H.block<3, 3>(0, speed).setIdentity();
  H.block<3, 3>(3, gyroscope).setIdentity();
  Vector6d residual, sigmas;
  residual << -state_.velocity, so3_log(Eigen::Quaterniond(over.turn)) / rest_window_s - state_.bias.gyroscope;
  sigmas << Eigen::Vector3d::Constant(rest_speed_sigma), Eigen::Vector3d::Constant(gyroscope_bias_sigma_at_rest);
  observe<6>(H, residual, sigmas);
}

void InertialFilter::restart(double time_s, const Pose& T_map_sensor) {
  state_.time_s = time_s;
  state_.T_map_imu = T_map_sensor * state_.T_sensor_imu;
  state_.velocity.setZero();
  auto& C = state_.covariance;
  C.topRows<9>().setZero();
  C.leftCols<9>().setZero();
  state_.with_mount.topRows<9>().setZero();
  set_block(C, speed, walking_speed_sigma);
  place_sensor(found_rad, found_m);
}

void InertialFilter::anchor() { place_sensor(exact_rad, exact_m); }

std::optional<InertialFilter::Prediction> InertialFilter::predict(double begin_s, double end_s) const {
  constexpr double max_overlap_s = 0.02;  // of two frames
  if (!started_ || begin_s < state_.time_s - max_overlap_s || !(end_s > begin_s)) return std::nullopt;
  const double later_s = state_.later_s;
  if (!unit_.data.cover(std::min(begin_s, state_.time_s) + later_s, end_s + later_s)) return std::nullopt;
  const double from_s = std::max(begin_s, state_.time_s);
  if (!(end_s > from_s)) return std::nullopt;
  Matrix18d F;
  InertialState begin = state_;
  if (from_s > state_.time_s)
    begin =
        propagated(state_, unit_.data.integrate(state_.time_s + later_s, from_s + later_s, state_.bias, unit_.noise),
                   unit_.noise, F);
  const auto over_frame = unit_.data.integrate(from_s + later_s, end_s + later_s, begin.bias, unit_.noise);
  Prediction out;
  out.state = propagated(begin, over_frame, unit_.noise, F);
  begin.rate_rad_s = unit_.data.at(from_s + later_s).angular_rate_rad_s - begin.bias.gyroscope;
  out.state.rate_rad_s = unit_.data.at(end_s + later_s).angular_rate_rad_s - begin.bias.gyroscope;
  // In this order: state at the end, pose of the unit at the begin, mount.
  out.joint.setZero();
  out.joint.topLeftCorner<18, 18>() = out.state.covariance;
  out.joint.block<6, 6>(18, 18) = begin.covariance.topLeftCorner<6, 6>();
  out.joint.block<18, 6>(0, 18) = F * begin.covariance.leftCols<6>();
  out.joint.block<6, 18>(18, 0) = out.joint.block<18, 6>(0, 18).transpose();
  out.joint.bottomRightCorner<7, 7>() = out.state.mount_covariance;
  out.joint.block<18, 7>(0, 24) = out.state.with_mount;
  out.joint.block<6, 7>(18, 24) = begin.with_mount.topRows<6>();
  out.joint.bottomLeftCorner<7, 24>() = out.joint.topRightCorner<24, 7>().transpose();
  out.to_sensor.setZero();
  out.to_sensor.block<6, 6>(0, 18) = pose_to_sensor(begin);
  out.to_sensor.block<6, 7>(0, 24) = mount_to_sensor(begin);
  out.to_sensor.block<6, 6>(6, 0) = pose_to_sensor(out.state);
  out.to_sensor.block<6, 7>(6, 24) = mount_to_sensor(out.state);
  out.covariance = out.to_sensor * out.joint * out.to_sensor.transpose();
  // Begin and end follow each other to hundredths of a millimetre: without a floor the prior cannot be inverted.
  for (const int pose : {0, 6}) {
    out.covariance.diagonal().segment<3>(pose).array() += floor_rad * floor_rad;
    out.covariance.diagonal().segment<3>(pose + 3).array() += floor_m * floor_m;
  }
  // A frame that overlaps the one before begins earlier than the state that its begin is taken from.
  const double overlap_s = from_s - begin_s;
  out.covariance.diagonal().segment<3>(0).array() += std::pow(overlap_s * begin.rate_rad_s.norm(), 2);
  out.covariance.diagonal().segment<3>(3).array() += std::pow(overlap_s * begin.velocity.norm(), 2);

  // The poses on the way: T(s) = interpolate(begin, end, s) after(s).
  const Pose T_imu_sensor = state_.T_sensor_imu.inverse();
  out.motion.T_map_begin = begin.T_map_imu * T_imu_sensor;
  out.motion.T_map_end = out.state.T_map_imu * T_imu_sensor;
  auto shape = std::make_shared<MotionShape>();
  Preintegration part;
  double at_s = from_s;
  for (std::size_t i = 0; i <= MotionShape::steps; ++i) {
    const double s = static_cast<double>(i) / static_cast<double>(MotionShape::steps),
                 to_s = std::min(end_s, std::max(from_s, begin_s + s * (end_s - begin_s)));
    unit_.data.walk(at_s + later_s, to_s + later_s,
                    [&](const Eigen::Vector3d& rate, const Eigen::Vector3d& force, double dt) {
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
  const Eigen::Matrix<double, 31, 12> gain = prior.ldlt().solve(p.to_sensor * p.joint).transpose();
  const Eigen::Matrix<double, 31, 1> error = gain * found;
  Matrix31d covariance = p.joint + gain * (posterior - prior) * gain.transpose();
  covariance = (0.5 * (covariance + covariance.transpose())).eval();
  InertialState out = moved(p.state, error.head<18>());
  out.covariance = covariance.topLeftCorner<18, 18>();
  if (!unit_.mount_sigmas) return out;
  out.mount_covariance = covariance.bottomRightCorner<7, 7>();
  out.with_mount = covariance.block<18, 7>(0, 24);
  out.T_sensor_imu.linear() =
      Eigen::Quaterniond(out.T_sensor_imu.linear() * so3_exp(error.segment<3>(24)).toRotationMatrix())
          .normalized()
          .toRotationMatrix();
  out.T_sensor_imu.translation() += error.segment<3>(27);
  // The state is that of a moment of the unit: with another clock, a moment later.
  const double later_s = error[30];
  const InertialSample sample = unit_.data.at(out.time_s + out.later_s);
  const Eigen::Matrix3d R = out.T_map_imu.linear();
  out.T_map_imu = turned_and_shifted(out.T_map_imu, later_s * (R * out.rate_rad_s), later_s * out.velocity);
  out.velocity += later_s * (R * (sample.specific_force_m_s2 - out.bias.accelerometer) + out.gravity);
  out.later_s += later_s;
  return out;
}

double InertialFilter::tension(const Prediction& p, const FrameMotion& motion) {
  Eigen::Matrix<double, 12, 1> found;
  found << difference(p.motion.T_map_begin, motion.T_map_begin), difference(p.motion.T_map_end, motion.T_map_end);
  return found.dot(p.covariance.ldlt().solve(found)) / 12;
}

Matrix6d InertialFilter::sensor_covariance(const InertialState& s) {
  const Matrix6d P = pose_to_sensor(s);
  const MatrixPoseMount J = mount_to_sensor(s);
  const Matrix6d mixed = P * s.with_mount.topRows<6>() * J.transpose();
  return P * s.covariance.topLeftCorner<6, 6>() * P.transpose() + mixed + mixed.transpose() +
         J * s.mount_covariance * J.transpose();
}

double InertialFilter::shift_sigma(const InertialState& state) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
      Eigen::Matrix3d(sensor_covariance(state).bottomRightCorner<3, 3>()));
  return std::sqrt(std::max(0.0, solver.eigenvalues()[2]));
}

}  // namespace bole::slam
