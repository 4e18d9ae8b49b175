// Pre-integration, the filter, the mount and the terms of the whole path: derivatives against differences, and results
// against exact motions.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "base/angles.h"
#include "slam/core/inertial/inertial_filter.h"
#include "slam/core/inertial/mount.h"
#include "slam/core/map/inertial_terms.h"
#include "synthetic/inertial_unit.h"

namespace bole::slam {
namespace {

using synthetic::inertial_record;

// A hand that walks, bobs and looks about.
Pose hand(double t) {
  Pose T = Pose::Identity();
  T.linear() = rotation_from_rpy(0.1 * std::sin(3 * t), 0.12 * std::sin(4 * t + 1), 0.8 * std::sin(0.9 * t) + 0.2 * t);
  T.translation() = Eigen::Vector3d(1.1 * t, 0.3 * std::sin(2 * t), 1.6 + 0.03 * std::sin(11 * t));
  return T;
}

InertialUnit unit_of(const InertialRecord& record) {
  InertialUnit unit;
  unit.data = InertialMeasurements(record);
  unit.T_sensor_imu = *record.T_sensor_imu;
  unit.noise = {2e-4, 2e-3, 1e-6, 1e-5};
  return unit;
}

InertialState state_at(const InertialUnit& unit, double t) {
  InertialState s;
  s.time_s = t;
  s.T_map_imu = hand(t) * unit.T_sensor_imu;
  constexpr double h = 1e-4;
  s.velocity =
      ((hand(t + h) * unit.T_sensor_imu).translation() - (hand(t - h) * unit.T_sensor_imu).translation()) / (2 * h);
  s.gravity = Eigen::Vector3d(0, 0, -9.81);
  s.covariance = 1e-6 * Matrix18d::Identity();
  return s;
}

Vector18d difference(const InertialState& from, const InertialState& to) {
  Vector18d d;
  d << so3_log(Eigen::Quaterniond(to.T_map_imu.linear() * from.T_map_imu.linear().transpose())),
      to.T_map_imu.translation() - from.T_map_imu.translation(), to.velocity - from.velocity,
      to.bias.gyroscope - from.bias.gyroscope, to.bias.accelerometer - from.bias.accelerometer,
      to.gravity - from.gravity;
  return d;
}

TEST(Preintegration, AnExactUnitGivesTheMotion) {
  const auto unit = unit_of(inertial_record(hand, 0, 5, {}, 400));
  Matrix18d F;
  const auto begin = state_at(unit, 1.003);
  const auto by = unit.data.integrate(1.003, 3.111, {}, unit.noise);
  EXPECT_NEAR(by.duration_s, 2.108, 1e-9);
  const auto end = propagated(begin, by, unit.noise, F);
  EXPECT_LT(difference(state_at(unit, 3.111), end).head<9>().cwiseAbs().maxCoeff(), 1e-3);
}

TEST(Preintegration, JacobiansAgreeWithDifferences) {
  const auto unit = unit_of(inertial_record(hand, 0, 5));
  const InertialBias bias{{0.01, -0.02, 0.005}, {0.1, 0.05, -0.2}};
  const auto by = unit.data.integrate(1, 1.7, bias, unit.noise);
  constexpr double h = 1e-5;
  for (int k = 0; k < 6; ++k) {
    InertialBias plus = bias, minus = bias;
    (k < 3 ? plus.gyroscope[k] : plus.accelerometer[k - 3]) += h;
    (k < 3 ? minus.gyroscope[k] : minus.accelerometer[k - 3]) -= h;
    const auto a = unit.data.integrate(1, 1.7, minus, unit.noise), b = unit.data.integrate(1, 1.7, plus, unit.noise);
    const Eigen::Vector3d turn = so3_log(Eigen::Quaterniond(by.turn.transpose() * b.turn)) -
                                 so3_log(Eigen::Quaterniond(by.turn.transpose() * a.turn)),
                          velocity = b.velocity - a.velocity, shift = b.shift - a.shift;
    const Eigen::Vector3d J_turn = k < 3 ? Eigen::Vector3d(by.turn_by_gyroscope.col(k)) : Eigen::Vector3d::Zero(),
                          J_velocity =
                              k < 3 ? by.velocity_by_gyroscope.col(k) : by.velocity_by_accelerometer.col(k - 3),
                          J_shift = k < 3 ? by.shift_by_gyroscope.col(k) : by.shift_by_accelerometer.col(k - 3);
    EXPECT_LT((turn / (2 * h) - J_turn).norm(), 1e-6) << k;
    EXPECT_LT((velocity / (2 * h) - J_velocity).norm(), 1e-5) << k;
    EXPECT_LT((shift / (2 * h) - J_shift).norm(), 1e-5) << k;
  }
}

// The covariance against the scatter of integrations of noisy measurements.
TEST(Preintegration, CovarianceIsTheScatter) {
  const InertialNoise noise{1e-3, 1e-2, 0, 0};
  const auto exact = inertial_record(hand, 0, 2, {}, 100);
  const auto by = InertialMeasurements(exact).integrate(0.5, 1.0, {}, noise);
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  Matrix9d scatter = Matrix9d::Zero();
  constexpr int tries = 3000;
  for (int i = 0; i < tries; ++i) {
    auto noisy = exact;
    for (auto& s : noisy.samples)
      for (int k = 0; k < 3; ++k) {
        s.angular_rate_rad_s[k] += 1e-3 * std::sqrt(100) * normal(random);
        s.specific_force_m_s2[k] += 1e-2 * std::sqrt(100) * normal(random);
      }
    const auto p = InertialMeasurements(noisy).integrate(0.5, 1.0, {}, noise);
    Eigen::Matrix<double, 9, 1> d;
    d << so3_log(Eigen::Quaterniond(by.turn.transpose() * p.turn)), p.velocity - by.velocity, p.shift - by.shift;
    scatter += d * d.transpose() / tries;
  }
  // The allowance for the scale factor is not noise.
  const Eigen::Vector3d scale = 0.004 * so3_log(Eigen::Quaterniond(by.turn));
  Matrix9d expected = by.covariance;
  expected.topLeftCorner<3, 3>() -= scale * scale.transpose();
  for (int k = 0; k < 9; ++k) EXPECT_NEAR(std::sqrt(scatter(k, k) / expected(k, k)), 1, 0.06) << k;
}

TEST(Preintegration, GapsAreNotCovered) {
  auto record = inertial_record(hand, 0, 2);
  std::erase_if(record.samples, [](const InertialSample& s) { return s.time_s > 0.8 && s.time_s < 1.2; });
  const InertialMeasurements data(record);
  EXPECT_TRUE(data.cover(0.1, 0.7));
  EXPECT_FALSE(data.cover(0.7, 1.3));
  EXPECT_FALSE(data.cover(0.9, 1.0));
  EXPECT_TRUE(data.cover(1.3, 1.9));
  EXPECT_FALSE(data.cover(1.3, 2.1));
  EXPECT_FALSE(data.cover(-0.1, 0.2));
}

TEST(InertialFilter, TransitionAgreesWithDifferences) {
  const auto unit = unit_of(inertial_record(hand, 0, 5));
  auto state = state_at(unit, 2);
  state.bias = {{0.01, -0.02, 0.005}, {0.1, 0.05, -0.2}};
  Matrix18d F;
  const auto after = [&](const InertialState& from) {
    Matrix18d ignored;
    return propagated(from, unit.data.integrate(2, 2.1, from.bias, unit.noise), unit.noise, ignored);
  };
  const auto end = propagated(state, unit.data.integrate(2, 2.1, state.bias, unit.noise), unit.noise, F);
  constexpr double h = 1e-5;
  for (int k = 0; k < 18; ++k) {
    Vector18d e = Vector18d::Zero();
    e[k] = h;
    const Vector18d column =
        (difference(end, after(moved(state, e))) - difference(end, after(moved(state, -e)))) / (2 * h);
    EXPECT_LT((column - F.col(k)).cwiseAbs().maxCoeff(), 1e-5) << k;
  }
}

// Frames whose poses are found to millimetres teach velocity, biases and gravity.
TEST(InertialFilter, LearnsBiasesAndGravityFromPoses) {
  const synthetic::InertialErrors errors = synthetic::small_unit();
  const auto record = inertial_record(hand, 0, 31, errors);
  const auto unit = unit_of(record);
  InertialFilter filter(unit);
  const auto start = filter.look(0);
  ASSERT_TRUE(start);
  EXPECT_FALSE(start->at_rest);
  filter.start(0, hand(0), *start);
  Matrix12d information = Matrix12d::Zero();
  for (const int pose : {0, 6}) {
    information.diagonal().segment<3>(pose).setConstant(1 / (5e-4 * 5e-4));
    information.diagonal().segment<3>(pose + 3).setConstant(1 / (5e-3 * 5e-3));
  }
  for (int i = 0; i < 300; ++i) {
    const double begin = 0.1 * i, end = begin + 0.1;
    const auto expected = filter.predict(begin, end);
    ASSERT_TRUE(expected);
    if (i > 20) {
      const Pose apart = expected->motion.T_map_end.inverse() * hand(end);
      EXPECT_LT(apart.translation().norm(), 0.02) << i;
      // The shape within the frame is that of the motion.
      const Pose middle = expected->motion.at(0.5).inverse() * hand(begin + 0.05);
      EXPECT_LT(middle.translation().norm(), 0.02) << i;
      EXPECT_LT(Eigen::AngleAxisd(middle.linear()).angle(), 0.005) << i;
    }
    // As registration would find it: the mean of what is expected and the truth by their weights.
    FrameMotion found;
    const auto between = [&](const Pose& from, const Pose& to) {
      Vector6d d;
      d << so3_log(Eigen::Quaterniond(to.linear() * from.linear().transpose())), to.translation() - from.translation();
      return d;
    };
    Eigen::Matrix<double, 12, 1> away;
    away << between(expected->motion.T_map_begin, hand(begin)), between(expected->motion.T_map_end, hand(end));
    const Eigen::Matrix<double, 12, 1> step =
        (information + expected->covariance.inverse()).ldlt().solve(information * away);
    const auto apply = [](Pose T, const Vector6d& d) {
      T.linear() = so3_exp(d.head<3>()).toRotationMatrix() * T.linear();
      T.translation() += d.tail<3>();
      return T;
    };
    found.T_map_begin = apply(expected->motion.T_map_begin, step.head<6>());
    found.T_map_end = apply(expected->motion.T_map_end, step.tail<6>());
    filter.set(filter.corrected(*expected, found, information));
  }
  const auto& state = filter.state();
  EXPECT_LT((state.bias.gyroscope - errors.gyroscope_bias).norm(), 1e-3);
  EXPECT_LT((state.bias.accelerometer - errors.accelerometer_bias).norm(), 0.03);
  EXPECT_LT((state.gravity - Eigen::Vector3d(0, 0, -9.81)).norm(), 0.03);
  EXPECT_LT(InertialFilter::shift_sigma(state), 0.006);
}

TEST(InertialFilter, AtRestGravityIsLevelToTheBias) {
  const auto still = [](double) -> Pose {
    Pose T = Pose::Identity();
    T.linear() = rotation_from_rpy(0.3, -0.2, 0.5);
    return T;
  };
  const auto errors = synthetic::small_unit();
  const auto unit = unit_of(inertial_record(still, 0, 3, errors));
  InertialFilter filter(unit);
  const auto start = filter.look(0.2);
  ASSERT_TRUE(start);
  EXPECT_TRUE(start->at_rest);
  EXPECT_LT((still(0).linear() * start->gravity_in_sensor - Eigen::Vector3d(0, 0, -9.81)).norm(),
            1.5 * errors.accelerometer_bias.norm());
  filter.start(0.2, still(0), *start);
  EXPECT_LT((filter.state().bias.gyroscope - errors.gyroscope_bias).norm(), 2e-3);
}

TEST(InertialTerms, AnExactUnitFitsAndJacobiansAgreeWithDifferences) {
  const auto unit = unit_of(inertial_record(hand, 0, 5, {}, 1000));
  const auto before = unit.data.integrate(2.0, 2.05, {}, unit.noise),
             after = unit.data.integrate(2.05, 2.11, {}, unit.noise);
  const Eigen::Vector3d gravity(0, 0, -9.81);
  const std::array<Pose, 3> T{hand(2.0), hand(2.05), hand(2.11)};
  const auto error = [&](const std::array<Pose, 3>& poses) {
    return InertialTerms::velocity_error(unit.T_sensor_imu, gravity, poses, before, after);
  };
  EXPECT_LT(error(T).norm(), 1e-4);
  const auto J = InertialTerms::velocity_jacobians(unit.T_sensor_imu, T, before, after);
  constexpr double h = 1e-6;
  for (std::size_t i = 0; i < 3; ++i)
    for (int k = 0; k < 6; ++k) {
      const auto with = [&](double step) {
        auto poses = T;
        if (k < 3)
          poses[i].linear() = so3_exp(step * Eigen::Vector3d::Unit(k)).toRotationMatrix() * poses[i].linear();
        else
          poses[i].translation()[k - 3] += step;
        return error(poses);
      };
      EXPECT_LT(((with(h) - with(-h)) / (2 * h) - J[i].col(k)).norm(), 1e-5) << i << " " << k;
    }
}

TEST(InertialTerms, TheMountsDerivativesAgreeWithDifferences) {
  const auto unit = unit_of(inertial_record(hand, 0, 5, {}, 1000));
  const auto before = unit.data.integrate(2.0, 2.05, {}, unit.noise),
             after = unit.data.integrate(2.05, 2.11, {}, unit.noise);
  const std::array<Pose, 3> T{hand(2.0), hand(2.05), hand(2.11)};
  const auto J = InertialTerms::velocity_by_mount(unit.T_sensor_imu, T, before, after);
  constexpr double h = 1e-6;
  for (int k = 0; k < 6; ++k) {
    const auto with = [&](double step) {
      Pose mount = unit.T_sensor_imu;
      if (k < 3)
        mount.linear() = mount.linear() * so3_exp(step * Eigen::Vector3d::Unit(k)).toRotationMatrix();
      else
        mount.translation()[k - 3] += step;
      return InertialTerms::velocity_error(mount, {0, 0, -9.81}, T, before, after);
    };
    EXPECT_LT(((with(h) - with(-h)) / (2 * h) - J.col(k)).norm(), 1e-6) << k;
  }
}

// The path of the hand at 20 Hz, each place off by noise of this standard deviation.
std::vector<StampedPose> jittering_nodes(double duration_s, double sd, unsigned seed = 5, double turn_sd_rad = 0) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0, sd);
  std::vector<StampedPose> nodes;
  for (int i = 0; i <= std::lround(20 * duration_s); ++i) {
    Pose T = hand(0.05 * i);
    for (int k = 0; k < 3; ++k) T.translation()[k] += normal(random);
    if (turn_sd_rad > 0) {
      const double scale = turn_sd_rad / sd, x = normal(random), y = normal(random), z = normal(random);
      T.linear() = so3_exp(scale * Eigen::Vector3d(x, y, z)).toRotationMatrix() * T.linear();
    }
    nodes.push_back({0.05 * i, T});
  }
  return nodes;
}

// A mount and a clock that are somewhat wrong come right with a path that is known to millimetres.
TEST(InertialTerms, FindTheMount) {
  const double late_s = 0.004;
  const auto record = inertial_record(hand, -1, 32, synthetic::small_unit(), 200, late_s);
  auto unit = unit_of(record);
  const Pose truth = unit.T_sensor_imu;
  unit.T_sensor_imu.linear() = truth.linear() * so3_exp({0.01, -0.008, 0.012}).toRotationMatrix();
  unit.T_sensor_imu.translation() += Eigen::Vector3d(0.04, 0.03, -0.05);
  unit.mount_sigmas = MountSigmas{0.01, 0.05, 0.005};
  const auto nodes = jittering_nodes(30, 0.003);
  Path path(nodes);
  InertialState state = state_at(unit, 0);
  InertialTerms terms(unit, state, 0, 30, 1);
  ASSERT_EQ(terms.calibrated(), 7u);
  for (int iteration = 0; iteration < 5; ++iteration) {
    BandedSystem system(nodes.size(), terms.unknowns());
    terms.add(path, system);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      Vector6d w, e;
      w << Eigen::Vector3d::Constant(1 / (5e-4 * 5e-4)), Eigen::Vector3d::Constant(1 / (3e-3 * 3e-3));
      const Pose &at = path.nodes()[i].T_target_sensor, &seen = nodes[i].T_target_sensor;
      e << so3_log(Eigen::Quaterniond(at.linear() * seen.linear().transpose())), at.translation() - seen.translation();
      system.block(i, 0) += w.asDiagonal();
      system.gradient(i) += w.cwiseProduct(e);
    }
    Eigen::VectorXd border;
    Eigen::MatrixXd covariance(10, 10);
    const auto steps = system.solve(border, &covariance);
    ASSERT_FALSE(steps.empty());
    for (std::size_t i = 0; i < steps.size(); ++i) {
      Pose T = path.nodes()[i].T_target_sensor;
      T.linear() = so3_exp(steps[i].head<3>()).toRotationMatrix() * T.linear();
      T.translation() += steps[i].tail<3>();
      path.set_pose(i, T);
    }
    terms.move(border, covariance);
  }
  EXPECT_NEAR(terms.time_offset_s(), late_s, 5e-4);
  const double turn = Eigen::AngleAxisd(truth.linear().transpose() * terms.T_sensor_imu().linear()).angle();
  EXPECT_LT(turn, 0.002);
  EXPECT_LT((terms.T_sensor_imu().translation() - truth.translation()).norm(), 0.012);
  ASSERT_TRUE(terms.mount_sigmas());
  EXPECT_LT(terms.mount_sigmas()->turn_rad, 0.002);
  EXPECT_LT(turn, 5 * terms.mount_sigmas()->turn_rad);
}

// Adjusts a path to nodes that are seen with errors of 1 mrad and 1 cm, and to the unit.
void adjust(Path& path, const std::vector<StampedPose>& seen, InertialTerms& terms) {
  for (int iteration = 0; iteration < 4; ++iteration) {
    BandedSystem system(seen.size(), terms.unknowns());
    terms.add(path, system);
    for (std::size_t i = 0; i < seen.size(); ++i) {
      Vector6d w, e;
      w << Eigen::Vector3d::Constant(1 / (1e-3 * 1e-3)), Eigen::Vector3d::Constant(1 / (1e-2 * 1e-2));
      const Pose &at = path.nodes()[i].T_target_sensor, &there = seen[i].T_target_sensor;
      e << so3_log(Eigen::Quaterniond(at.linear() * there.linear().transpose())),
          at.translation() - there.translation();
      system.block(i, 0) += w.asDiagonal();
      system.gradient(i) += w.cwiseProduct(e);
    }
    Eigen::VectorXd border;
    Eigen::MatrixXd covariance(3, 3);
    const auto steps = system.solve(border, &covariance);
    ASSERT_FALSE(steps.empty());
    for (std::size_t i = 0; i < steps.size(); ++i) {
      Pose T = path.nodes()[i].T_target_sensor;
      T.linear() = so3_exp(steps[i].head<3>()).toRotationMatrix() * T.linear();
      T.translation() += steps[i].tail<3>();
      path.set_pose(i, T);
    }
    terms.move(border, covariance);
  }
}

// Nodes that jitter by a centimetre about a true path come nearer to it by the unit alone, held at a few places.
TEST(InertialTerms, SmoothAPathAndFindTheBiases) {
  const auto errors = synthetic::small_unit();
  const auto unit = unit_of(inertial_record(hand, -1, 22, errors));
  const auto nodes = jittering_nodes(20, 0.01);
  Path path(nodes);
  InertialState state = state_at(unit, 0);
  state.gravity = Eigen::Vector3d(0.2, -0.1, -9.8);
  InertialTerms terms(unit, state, 0, 20, 1);
  adjust(path, nodes, terms);
  double squared = 0;
  for (const auto& node : path.nodes())
    squared += (node.T_target_sensor.translation() - hand(node.time_s).translation()).squaredNorm();
  EXPECT_LT(std::sqrt(squared / 401), 0.006);  // 0.017 before
  const auto bias = terms.bias_at(10);
  EXPECT_LT((bias.gyroscope - errors.gyroscope_bias).norm(), 1e-3);
  EXPECT_LT((bias.accelerometer - errors.accelerometer_bias).norm(), 0.04);
  EXPECT_LT((terms.gravity() - Eigen::Vector3d(0, 0, -9.81)).norm(), 0.04);
}

// What is said of the vertical holds: errors of both axes, in the standard deviation that is given, scatter by no more
// than 1. By less, since the terms allow for walks of the biases, which this unit has not.
TEST(InertialTerms, TheStandardDeviationOfTheLevelIsThatOfItsErrors) {
  double squared = 0, largest_deg = 0;
  constexpr int walks = 20;
  for (unsigned seed = 1; seed <= walks; ++seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> bias(0, 0.07);
    auto errors = synthetic::small_unit();
    errors.seed = seed;
    errors.accelerometer_bias = Eigen::Vector3d(bias(random), bias(random), bias(random));
    const auto unit = unit_of(inertial_record(hand, -1, 22, errors));
    const auto nodes = jittering_nodes(20, 0.01, seed, 1e-3);
    Path path(nodes);
    InertialTerms terms(unit, state_at(unit, 0), 0, 20, 1);
    adjust(path, nodes, terms);
    ASSERT_TRUE(terms.level_sigma_rad());
    const Eigen::Vector2d tilt = terms.gravity().head<2>() / terms.gravity().z();
    squared += tilt.squaredNorm() / std::pow(*terms.level_sigma_rad(), 2);
    largest_deg = std::max(largest_deg, degrees(tilt.norm()));
  }
  const double scatter = std::sqrt(squared / (2 * walks));
  std::printf("errors of the level: %.2f of their standard deviation, largest %.3f deg\n", scatter, largest_deg);
  EXPECT_GT(scatter, 0.3);
  EXPECT_LT(scatter, 1.1);
  EXPECT_LT(largest_deg, 0.2);
}

std::vector<TimedMotion> frames_of(double seconds, double noise_rad, double noise_m) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  const auto shaken = [&](const Pose& T) {
    Pose out = T;
    const Eigen::Vector3d turn(normal(random), normal(random), normal(random)),
        shift(normal(random), normal(random), normal(random));
    out.linear() = so3_exp(noise_rad * turn).toRotationMatrix() * T.linear();
    out.translation() += noise_m * shift;
    return out;
  };
  std::vector<TimedMotion> frames;
  for (double t = 1; t + 0.1 < seconds; t += 0.1)
    frames.push_back({t, t + 0.1, {shaken(hand(t)), shaken(hand(t + 0.1))}});
  return frames;
}

TEST(Mount, TurnAndClockAreFoundInTheirLimits) {
  const auto record = inertial_record(hand, 0, 42, synthetic::small_unit(), 200, 0.0437);
  const auto mount = estimate_mount(record, frames_of(41, 4e-4, 0.003), std::nullopt);
  EXPECT_EQ(mount.unknown, "");
  const Pose truth = synthetic::some_mount();
  const double turn = Eigen::AngleAxisd(truth.linear().transpose() * mount.T_sensor_imu.linear()).angle();
  EXPECT_LT(turn, 0.004);
  EXPECT_LT(turn, 4 * mount.turn_sigma_rad + 1e-4);
  EXPECT_NEAR(mount.time_offset_s, 0.0437, 0.002);
  EXPECT_LT(std::abs(mount.time_offset_s - 0.0437), 4 * mount.time_sigma_s + 2e-4);
}

// Frames of a motion, each turn off by noise as registration leaves it.
std::vector<TimedMotion> noisy_frames(const std::function<Pose(double)>& motion, double end_s, double frame_s,
                                      unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0, 4e-4);
  std::vector<TimedMotion> frames;
  for (double t = 1; t < end_s; t += frame_s) {
    FrameMotion found{motion(t), motion(t + frame_s)};
    found.T_map_end.linear() =
        so3_exp({normal(random), normal(random), normal(random)}).toRotationMatrix() * found.T_map_end.linear();
    frames.push_back({t, t + frame_s, found});
  }
  return frames;
}

synthetic::InertialErrors noisy_unit() {
  auto errors = synthetic::small_unit();
  errors.noise = {2e-4, 2e-3, 0, 0};
  return errors;
}

Pose unmoved(double) { return Pose::Identity(); }

Pose flat(double t) {
  Pose T = Pose::Identity();
  T.linear() = rotation_from_rpy(0, 0, std::sin(t));
  T.translation() = Eigen::Vector3d(t, 0, 0);
  return T;
}

// However long: noise about the other axes is no turning.
TEST(Mount, AWalkThatTurnsAboutOneAxisDoesNotTell) {
  for (const double frame_s : {0.1, 0.05})
    for (unsigned seed = 1; seed <= 4; ++seed)
      for (const auto& errors : {synthetic::small_unit(), noisy_unit()}) {
        const auto mount =
            estimate_mount(inertial_record(flat, 0, 62, errors), noisy_frames(flat, 60, frame_s, seed), 0.0);
        EXPECT_NE(mount.unknown.find("turns too little about some axis"), std::string::npos) << mount.unknown;
      }
}

TEST(Mount, IsNotCheckedAtRestNorInTurnsAboutOneAxis) {
  for (const auto& motion : {std::function<Pose(double)>(unmoved), std::function<Pose(double)>(flat)})
    for (unsigned seed = 1; seed <= 4; ++seed)
      for (const auto& errors : {synthetic::small_unit(), noisy_unit()}) {
        const auto record = inertial_record(motion, 0, 62, errors);
        const auto frames = noisy_frames(motion, 60, 0.1, seed);
        for (std::size_t n = 20; n <= frames.size(); n += 20)
          EXPECT_FALSE(check_mount(record, {frames.begin(), frames.begin() + static_cast<std::ptrdiff_t>(n)}, 0).judged)
              << n;
      }
}

// Ten seconds at rest, then a walk: the right mount is confirmed, a wrong one found out.
TEST(Mount, IsCheckedOnceTheWalkBegins) {
  const auto later = [](double t) { return hand(std::max(0.0, t - 11)); };
  auto record = inertial_record(later, 0, 32, noisy_unit());
  const auto frames = noisy_frames(later, 30, 0.1, 1);
  const auto judged = [&]() {
    for (std::size_t n = 20; n <= frames.size(); n += 20)
      if (const auto check = check_mount(record, {frames.begin(), frames.begin() + static_cast<std::ptrdiff_t>(n)}, 0);
          check.judged)
        return check;
    return MountCheck{};
  };
  const auto right = judged();
  ASSERT_TRUE(right.judged);
  EXPECT_LT(right.off_rad, std::max(0.14, 3 * right.sigma_rad));
  record.T_sensor_imu = Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ()) * *record.T_sensor_imu;
  const auto wrong = judged();
  ASSERT_TRUE(wrong.judged);
  EXPECT_NEAR(wrong.off_rad, 0.5, 3 * wrong.sigma_rad + 0.05);
}

// The standard deviation is that of the errors over repetitions.
TEST(Mount, TheStandardDeviationIsThatOfTheErrors) {
  double squared = 0, sigma = 0;
  constexpr unsigned tries = 24;
  const auto record = inertial_record(hand, 0, 22, noisy_unit());
  for (unsigned seed = 1; seed <= tries; ++seed) {
    const auto mount = estimate_mount(record, noisy_frames(hand, 20, 0.1, seed), 0.0);
    EXPECT_EQ(mount.unknown, "");
    squared += std::pow(
        Eigen::AngleAxisd(synthetic::some_mount().linear().transpose() * mount.T_sensor_imu.linear()).angle(), 2);
    sigma += mount.turn_sigma_rad / tries;
  }
  const double rms = std::sqrt(squared / tries);
  EXPECT_GT(sigma, 0.5 * rms);
  EXPECT_LT(sigma, 2 * rms);
}

// Frames that do not follow each other show no changes of velocity: the lever arm stays as little known as before.
TEST(Mount, ALeverArmThatWasNotTriedIsNotKnown) {
  auto frames = noisy_frames(hand, 40, 0.1, 1);
  std::vector<TimedMotion> every_second;
  for (std::size_t i = 0; i < frames.size(); i += 2) every_second.push_back(frames[i]);
  const auto mount = estimate_mount(inertial_record(hand, 0, 42, noisy_unit()), every_second, 0.0);
  EXPECT_EQ(mount.unknown, "");
  EXPECT_FALSE(mount.lever_known);
  EXPECT_GT(mount.lever_sigma, 0.1);
}

TEST(Mount, AUnitOfAnotherWalkIsRefused) {
  const auto other = [](double t) -> Pose {
    Pose T = hand(1.7 * t + 40);
    T.linear() = T.linear() * rotation_from_rpy(std::sin(5 * t), 0, 0);
    return T;
  };
  const auto mount = estimate_mount(inertial_record(other, 0, 42), frames_of(41, 4e-4, 0.003), std::nullopt);
  EXPECT_NE(mount.unknown, "");
}

}  // namespace
}  // namespace bole::slam
