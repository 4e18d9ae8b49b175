#include "slam/core/map/inertial_terms.h"

#include <algorithm>
#include <cmath>

namespace bole::slam {
namespace {

constexpr double knot_spacing_s = 10;
constexpr double max_knots = 32;  // their columns are dense: more would take memory on long walks
constexpr double gravity_m_s2 = 9.81, gravity_sigma = 0.03;
// The path is cubic between nodes, and points that were matched wrongly bend it: no term is surer than this.
constexpr double floor_turn_rad = 1e-4, floor_acceleration = 0.03;
constexpr double start_gyroscope_sigma = 0.02, start_accelerometer_sigma = 0.3;
constexpr double clock_step_s = 0.002;
// Biases also follow the temperature of the unit: no walk is slower than this within 10 s.
constexpr double walk_gyroscope = 2e-4, walk_accelerometer = 5e-3;

}  // namespace

InertialTerms::InertialTerms(const InertialUnit& unit, const InertialState& state, double begin_s, double end_s,
                             double trust)
    : unit_(unit),
      T_sensor_imu_(unit.T_sensor_imu),
      sigmas_(unit.mount_sigmas),
      begin_s_(begin_s),
      trust_(trust),
      gravity_(state.gravity) {
  const double length = std::max(end_s - begin_s, 1e-3);
  const double pieces = std::clamp(std::ceil(length / knot_spacing_s), 1.0, max_knots);
  spacing_s_ = length / pieces;
  knots_.assign(static_cast<std::size_t>(pieces) + 1, state.bias);
}

InertialTerms::Knot InertialTerms::knot_at(double time_s) const {
  const double x = std::clamp((time_s - begin_s_) / spacing_s_, 0.0, static_cast<double>(knots_.size() - 1));
  const auto first = std::min(static_cast<std::size_t>(x), knots_.size() - 2);
  return {first, x - static_cast<double>(first)};
}

InertialBias InertialTerms::bias_at(double time_s) const {
  const auto [k, u] = knot_at(time_s);
  return {(1 - u) * knots_[k].gyroscope + u * knots_[k + 1].gyroscope,
          (1 - u) * knots_[k].accelerometer + u * knots_[k + 1].accelerometer};
}

Eigen::Vector3d InertialTerms::velocity_error(const Pose& T_sensor_imu, const Eigen::Vector3d& gravity,
                                              const std::array<Pose, 3>& T, const Preintegration& a,
                                              const Preintegration& b) {
  const Eigen::Vector3d p0 = T[0] * T_sensor_imu.translation(), p1 = T[1] * T_sensor_imu.translation(),
                        p2 = T[2] * T_sensor_imu.translation();
  const Eigen::Matrix3d R0 = T[0].linear() * T_sensor_imu.linear(), R1 = T[1].linear() * T_sensor_imu.linear();
  const double T0 = a.duration_s, T1 = b.duration_s;
  return (p2 - p1) / T1 - (p1 - p0) / T0 - 0.5 * (T0 + T1) * gravity - R0 * (a.velocity - a.shift / T0) -
         R1 * b.shift / T1;
}

std::array<Eigen::Matrix<double, 3, 6>, 3> InertialTerms::velocity_jacobians(const Pose& T_sensor_imu,
                                                                             const std::array<Pose, 3>& T,
                                                                             const Preintegration& a,
                                                                             const Preintegration& b) {
  const double T0 = a.duration_s, T1 = b.duration_s;
  const std::array<double, 3> share{1 / T0, -1 / T0 - 1 / T1, 1 / T1};
  const std::array<Eigen::Vector3d, 3> force{T[0].linear() * T_sensor_imu.linear() * (a.velocity - a.shift / T0),
                                             T[1].linear() * T_sensor_imu.linear() * b.shift / T1,
                                             Eigen::Vector3d::Zero()};
  std::array<Eigen::Matrix<double, 3, 6>, 3> J;
  for (std::size_t i = 0; i < 3; ++i)
    J[i] << -share[i] * skew(T[i].linear() * T_sensor_imu.translation()) + skew(force[i]),
        share[i] * Eigen::Matrix3d::Identity();
  return J;
}

Eigen::Matrix<double, 3, 6> InertialTerms::velocity_by_mount(const Pose& T_sensor_imu, const std::array<Pose, 3>& T,
                                                             const Preintegration& a, const Preintegration& b) {
  const double T0 = a.duration_s, T1 = b.duration_s;
  const Eigen::Matrix3d R0 = T[0].linear() * T_sensor_imu.linear(), R1 = T[1].linear() * T_sensor_imu.linear();
  Eigen::Matrix<double, 3, 6> J;
  J << R0 * skew(a.velocity - a.shift / T0) + R1 * skew(b.shift / T1),
      (T[2].linear() - T[1].linear()) / T1 - (T[1].linear() - T[0].linear()) / T0;
  return J;
}

void InertialTerms::add_equation(std::size_t first_node, std::span<const Eigen::Matrix<double, 3, 6>> by_nodes,
                                 double time_s, const Eigen::Matrix<double, 3, 6>& by_bias,
                                 const Eigen::Matrix<double, 3, 3>& by_gravity,
                                 const Eigen::Matrix<double, 3, 7>& by_mount, const Eigen::Vector3d& error,
                                 const Eigen::Matrix3d& W, BandedSystem& system) const {
  for (std::size_t a = 0; a < by_nodes.size(); ++a) {
    system.gradient(first_node + a) += by_nodes[a].transpose() * W * error;
    for (std::size_t b = a; b < by_nodes.size(); ++b)
      system.block(first_node + a, b - a) += by_nodes[a].transpose() * W * by_nodes[b];
  }
  // Knot, next knot, gravity, mount.
  const auto [knot, u] = knot_at(time_s);
  Eigen::Matrix<double, 3, 22> B;
  B << (1 - u) * by_bias, u * by_bias, by_gravity, by_mount;
  const std::array<std::size_t, 4> rows{6 * knot, 6 * (knot + 1), 6 * knots_.size(), 6 * knots_.size() + 3};
  constexpr std::array<Eigen::Index, 4> at{0, 6, 12, 15}, size{6, 6, 3, 7};
  const std::size_t parts = calibrated() > 0 ? 4 : 3;
  for (std::size_t a = 0; a < parts; ++a) {
    const Eigen::MatrixXd weighted = B.middleCols(at[a], size[a]).transpose() * W;
    for (std::size_t i = 0; i < by_nodes.size(); ++i)
      system.add_border(rows[a], first_node + i, Eigen::MatrixXd(weighted * by_nodes[i]));
    system.border_gradient().segment(static_cast<Eigen::Index>(rows[a]), size[a]) += weighted * error;
    for (std::size_t b = 0; b <= a; ++b)
      system.add_corner(rows[a], rows[b], Eigen::MatrixXd(weighted * B.middleCols(at[b], size[b])));
  }
}

// Measurements of later_s after the time that they are taken for.
Preintegration InertialTerms::integrated(double begin_s, double end_s, double later_s) const {
  return unit_.data.integrate(begin_s + later_s, end_s + later_s, bias_at(0.5 * (begin_s + end_s)), unit_.noise);
}

Eigen::Vector3d InertialTerms::rate_at(double time_s) const {
  return unit_.data.at(time_s + later_s_).angular_rate_rad_s - bias_at(time_s).gyroscope;
}

void InertialTerms::add_turn(const Path& path, std::size_t node, const Preintegration& by, BandedSystem& system) {
  const auto& nodes = path.nodes();
  const Eigen::Matrix3d R0 = nodes[node].T_target_sensor.linear() * T_sensor_imu_.linear(),
                        R1 = nodes[node + 1].T_target_sensor.linear() * T_sensor_imu_.linear();
  const Eigen::Vector3d error = so3_log(Eigen::Quaterniond(R1 * (R0 * by.turn).transpose()));
  Eigen::Matrix3d covariance = R1 * by.covariance.topLeftCorner<3, 3>() * R1.transpose();
  covariance.diagonal().array() += floor_turn_rad * floor_turn_rad;
  turn_rms_ += error.squaredNorm();
  std::array<Eigen::Matrix<double, 3, 6>, 2> by_nodes;
  by_nodes[0] << -Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Zero();
  by_nodes[1] << Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Zero();
  Eigen::Matrix<double, 3, 6> by_bias;
  by_bias << -R1 * by.turn_by_gyroscope, Eigen::Matrix3d::Zero();
  Eigen::Matrix<double, 3, 7> by_mount = Eigen::Matrix<double, 3, 7>::Zero();
  if (calibrated() > 0) {
    by_mount.leftCols<3>() = R1 * (Eigen::Matrix3d::Identity() - by.turn.transpose());
    by_mount.col(6) = -R1 * (rate_at(nodes[node + 1].time_s) - by.turn.transpose() * rate_at(nodes[node].time_s));
  }
  add_equation(node, by_nodes, 0.5 * (nodes[node].time_s + nodes[node + 1].time_s), by_bias, Eigen::Matrix3d::Zero(),
               by_mount, error, covariance.inverse() / trust_, system);
}

void InertialTerms::add_velocity(const Path& path, std::size_t node, const Preintegration& before,
                                 const Preintegration& after, BandedSystem& system) {
  const auto& nodes = path.nodes();
  const std::array<Pose, 3> T{nodes[node - 1].T_target_sensor, nodes[node].T_target_sensor,
                              nodes[node + 1].T_target_sensor};
  const double T0 = before.duration_s, T1 = after.duration_s;
  const Eigen::Vector3d error = velocity_error(T_sensor_imu_, gravity_, T, before, after);
  velocity_rms_ += error.squaredNorm();
  // White noise of the force in both stretches, weighted by the time to the node between them.
  const double variance = std::pow(unit_.noise.accelerometer_m_s2_sqrt_hz, 2) * (T0 + T1) / 3 +
                          std::pow(floor_acceleration * 0.5 * (T0 + T1), 2);
  const auto by_nodes = velocity_jacobians(T_sensor_imu_, T, before, after);
  const Eigen::Matrix3d R0 = T[0].linear() * T_sensor_imu_.linear(), R1 = T[1].linear() * T_sensor_imu_.linear();
  Eigen::Matrix<double, 3, 6> by_bias;
  by_bias << -R0 * (before.velocity_by_gyroscope - before.shift_by_gyroscope / T0) - R1 * after.shift_by_gyroscope / T1,
      -R0 * (before.velocity_by_accelerometer - before.shift_by_accelerometer / T0) -
          R1 * after.shift_by_accelerometer / T1;
  Eigen::Matrix<double, 3, 7> by_mount = Eigen::Matrix<double, 3, 7>::Zero();
  const double begin_s = nodes[node - 1].time_s, middle_s = nodes[node].time_s, end_s = nodes[node + 1].time_s;
  if (calibrated() > 0 && unit_.data.cover(begin_s + later_s_ - clock_step_s, end_s + later_s_ + clock_step_s)) {
    by_mount.leftCols<6>() = velocity_by_mount(T_sensor_imu_, T, before, after);
    const auto error_at = [&](double later_s) {
      return velocity_error(T_sensor_imu_, gravity_, T, integrated(begin_s, middle_s, later_s),
                            integrated(middle_s, end_s, later_s));
    };
    by_mount.col(6) = (error_at(later_s_ + clock_step_s) - error_at(later_s_ - clock_step_s)) / (2 * clock_step_s);
  }
  add_equation(node - 1, by_nodes, middle_s, by_bias, -0.5 * (T0 + T1) * Eigen::Matrix3d::Identity(), by_mount, error,
               Eigen::Matrix3d::Identity() / (variance * trust_), system);
}

void InertialTerms::add_mount_prior(BandedSystem& system) const {
  const auto& s = *unit_.mount_sigmas;
  Eigen::Matrix<double, 7, 1> sigma, moved;
  sigma << Eigen::Vector3d::Constant(s.turn_rad), Eigen::Vector3d::Constant(s.lever), s.time_s;
  moved << so3_log(Eigen::Quaterniond(unit_.T_sensor_imu.linear().transpose() * T_sensor_imu_.linear())),
      T_sensor_imu_.translation() - unit_.T_sensor_imu.translation(), later_s_;
  const Eigen::Matrix<double, 7, 1> w = (2 * sigma).cwiseAbs2().cwiseInverse() / trust_;
  const std::size_t row = 6 * knots_.size() + 3;
  system.add_corner(row, row, Eigen::MatrixXd(w.asDiagonal()));
  system.border_gradient().tail<7>() += w.cwiseProduct(moved);
}

void InertialTerms::add_priors(BandedSystem& system) const {
  auto& g = system.border_gradient();
  const auto weight = [&](double sigma) { return 1 / (sigma * sigma * trust_); };
  const auto diagonal = [&](double gyroscope, double accelerometer) {
    Vector6d w;
    w << Eigen::Vector3d::Constant(weight(gyroscope)), Eigen::Vector3d::Constant(weight(accelerometer));
    return w;
  };
  const auto as_vector = [](const InertialBias& b) {
    Vector6d v;
    v << b.gyroscope, b.accelerometer;
    return v;
  };
  const Vector6d start = diagonal(start_gyroscope_sigma, start_accelerometer_sigma);
  system.add_corner(0, 0, Matrix6d(start.asDiagonal()));
  g.head<6>() += start.cwiseProduct(as_vector(knots_.front()));
  const double root = std::sqrt(spacing_s_ / knot_spacing_s);
  const Vector6d walk = diagonal(
      std::max(walk_gyroscope * root, unit_.noise.gyroscope_walk_rad_s2_sqrt_hz * std::sqrt(spacing_s_)),
      std::max(walk_accelerometer * root, unit_.noise.accelerometer_walk_m_s3_sqrt_hz * std::sqrt(spacing_s_)));
  for (std::size_t k = 0; k + 1 < knots_.size(); ++k) {
    const Vector6d step = walk.cwiseProduct(as_vector(knots_[k + 1]) - as_vector(knots_[k]));
    system.add_corner(6 * k, 6 * k, Matrix6d(walk.asDiagonal()));
    system.add_corner(6 * (k + 1), 6 * (k + 1), Matrix6d(walk.asDiagonal()));
    system.add_corner(6 * (k + 1), 6 * k, Matrix6d(-Matrix6d(walk.asDiagonal())));
    g.segment<6>(static_cast<Eigen::Index>(6 * k)) -= step;
    g.segment<6>(static_cast<Eigen::Index>(6 * (k + 1))) += step;
  }
  const Eigen::Vector3d down = gravity_.normalized();
  const double w = weight(gravity_sigma);
  system.add_corner(6 * knots_.size(), 6 * knots_.size(),
                    Eigen::Matrix3d(w * down * down.transpose() + 1e-6 * w * Eigen::Matrix3d::Identity()));
  g.segment<3>(static_cast<Eigen::Index>(6 * knots_.size())) += w * (gravity_.norm() - gravity_m_s2) * down;
  if (calibrated() > 0) add_mount_prior(system);
}

void InertialTerms::add(const Path& path, BandedSystem& system) {
  const auto& nodes = path.nodes();
  std::vector<Preintegration> pieces(nodes.size() - 1);
  std::vector<char> covered(nodes.size() - 1, 0);
  turn_rms_ = velocity_rms_ = 0;
  double turns = 0, velocities = 0;
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
    const double begin_s = nodes[i].time_s, end_s = nodes[i + 1].time_s;
    covered[i] = unit_.data.cover(begin_s + later_s_, end_s + later_s_);
    if (!covered[i]) continue;
    pieces[i] = integrated(begin_s, end_s, later_s_);
    add_turn(path, i, pieces[i], system);
    ++turns;
    if (i == 0 || !covered[i - 1]) continue;
    add_velocity(path, i, pieces[i - 1], pieces[i], system);
    ++velocities;
  }
  add_priors(system);
  turn_rms_ = turns > 0 ? std::sqrt(turn_rms_ / turns) : 0;
  velocity_rms_ = velocities > 0 ? std::sqrt(velocity_rms_ / velocities) : 0;
}

void InertialTerms::move(const Eigen::VectorXd& step, const Eigen::MatrixXd& covariance) {
  for (std::size_t k = 0; k < knots_.size(); ++k) {
    knots_[k].gyroscope += step.segment<3>(static_cast<Eigen::Index>(6 * k));
    knots_[k].accelerometer += step.segment<3>(static_cast<Eigen::Index>(6 * k + 3));
  }
  gravity_ += step.segment<3>(static_cast<Eigen::Index>(6 * knots_.size()));
  // All weights of the system are greater by 1 / trust, since its points count in full.
  if (covariance.rows() >= 3) {
    const Eigen::Vector3d down = gravity_.normalized();
    const Eigen::Matrix3d C = covariance.topLeftCorner<3, 3>() / trust_;
    level_sigma_rad_ = std::sqrt(std::max(0.0, C.trace() - down.dot(C * down)) / 2) / gravity_.norm();
  }
  if (calibrated() == 0) return;
  const Eigen::Matrix<double, 7, 1> mount = step.tail<7>();
  T_sensor_imu_.linear() = T_sensor_imu_.linear() * so3_exp(mount.head<3>()).toRotationMatrix();
  T_sensor_imu_.translation() += mount.segment<3>(3);
  later_s_ += mount[6];
  if (covariance.rows() != 10) return;
  const auto worst = [&](Eigen::Index first, Eigen::Index count) {
    return std::sqrt(std::max(0.0, covariance.diagonal().segment(3 + first, count).maxCoeff()) / trust_);
  };
  sigmas_ = {worst(0, 3), worst(3, 3), worst(6, 1)};
}

}  // namespace bole::slam
