// The simulated inertial unit: integrating what it measures gives the walk back.
#include "sim/core/walk/imu.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/angles.h"
#include "base/resources.h"
#include "modules/sim/plots.h"
#include "sim/core/plot/build_scene.h"
#include "sim/core/walk/route.h"
#include "sim/core/walk/walk.h"

namespace bole::sim {
namespace {

Walk demo_walk() {
  const Forest forest = make_forest(read_recipe(resource_path("plots/demo.json")), 1);
  const PlotScene scene = build_scene(forest, 1);
  const auto route =
      plan_route(walk_pattern(forest.recipe.size_m, 6), forest, scene.vegetation.obstacles, Walk::step_m);
  WalkParameters parameters;
  parameters.turn_rad = radians(180);
  return Walk(route, forest.terrain, parameters, 1);
}

// Strapdown integration by the midpoint rule.
TEST(Imu, what_it_measures_integrates_to_the_walk) {
  const Walk walk = demo_walk();
  const ImuParameters exact{.errors = {}, .rate_hz = 1000};
  const auto record = simulate_imu([&](double t) { return walk.pose(t); }, 20, 100, exact, 1);
  ASSERT_EQ(record.samples.size(), 20001u);
  ASSERT_TRUE(record.T_sensor_imu);
  const auto truth = [&](double t) -> Pose { return walk.pose(t) * *record.T_sensor_imu; };
  Pose T = truth(0);
  constexpr double h = 1e-4;
  Eigen::Vector3d velocity = (truth(h).translation() - truth(-h).translation()) / (2 * h);
  const Eigen::Vector3d gravity(0, 0, -gravity_m_s2);
  double moved = 0;
  for (std::size_t i = 0; i + 1 < record.samples.size(); ++i) {
    const auto &a = record.samples[i], &b = record.samples[i + 1];
    const double dt = b.time_s - a.time_s;
    const Eigen::Vector3d turn = 0.5 * dt * (a.angular_rate_rad_s + b.angular_rate_rad_s);
    const Eigen::Matrix3d middle = T.linear() * so3_exp(0.5 * turn).toRotationMatrix();
    const Eigen::Vector3d acceleration = middle * (0.5 * (a.specific_force_m_s2 + b.specific_force_m_s2)) + gravity;
    T.translation() += dt * velocity + 0.5 * dt * dt * acceleration;
    velocity += dt * acceleration;
    T.linear() = T.linear() * so3_exp(turn).toRotationMatrix();
    moved = std::max(moved, (T.translation() - truth(0).translation()).norm());
  }
  EXPECT_GT(moved, 5);
  EXPECT_LT((T.translation() - truth(20).translation()).norm(), 2e-3);
  EXPECT_LT(Eigen::AngleAxisd(T.linear().transpose() * truth(20).linear()).angle(), 1e-5);
}

TEST(Imu, noise_and_biases_are_those_of_the_grade) {
  const auto still = [](double) -> Pose { return Pose::Identity(); };
  for (const ImuGrade grade : {ImuGrade::consumer, ImuGrade::industrial, ImuGrade::tactical}) {
    const auto errors = errors_of(grade);
    const auto record = simulate_imu(still, 20, 0, {.errors = errors, .rate_hz = 200}, 3);
    const Eigen::Matrix3d R_imu_world = mounted_imu().linear().transpose();
    Eigen::Vector3d mean_rate = Eigen::Vector3d::Zero(), mean_force = Eigen::Vector3d::Zero();
    for (const auto& s : record.samples) mean_rate += s.angular_rate_rad_s, mean_force += s.specific_force_m_s2;
    const auto n = static_cast<double>(record.samples.size());
    mean_rate /= n;
    mean_force /= n;
    double rate2 = 0, force2 = 0;
    for (const auto& s : record.samples) {
      rate2 += (s.angular_rate_rad_s - mean_rate).squaredNorm() / (3 * n);
      force2 += (s.specific_force_m_s2 - mean_force).squaredNorm() / (3 * n);
    }
    // Over 20 s the walk of the biases adds little to the noise.
    EXPECT_NEAR(std::sqrt(rate2) / (errors.noise.gyroscope_rad_s_sqrt_hz * std::sqrt(200)), 1, 0.1);
    EXPECT_NEAR(std::sqrt(force2) / (errors.noise.accelerometer_m_s2_sqrt_hz * std::sqrt(200)), 1, 0.1);
    EXPECT_LT(mean_rate.norm(), 4 * std::sqrt(3.0) * errors.gyroscope_bias_rad_s + 1e-3);
    const Eigen::Vector3d off = mean_force - gravity_m_s2 * R_imu_world.col(2);
    EXPECT_LT(off.norm(), 4 * std::sqrt(3.0) * (errors.accelerometer_bias_m_s2 + errors.accelerometer_scale * 9.81));
    EXPECT_GT(off.norm(), 0.02 * errors.accelerometer_bias_m_s2);
  }
}

// What remains of each error where the others are nil, as a share of what it should be over many units.
TEST(Imu, biases_scales_and_walks_have_the_size_of_the_grade) {
  constexpr int units = 60;
  constexpr double duration_s = 25, rate_hz = 20;
  const auto still = [](double) -> Pose { return Pose::Identity(); };
  const auto turning = [](double t) -> Pose {
    Pose T = Pose::Identity();
    T.linear() = Eigen::AngleAxisd(t, Eigen::Vector3d(1, 1, 1).normalized()).toRotationMatrix();
    return T;
  };
  for (const ImuGrade grade : {ImuGrade::consumer, ImuGrade::industrial, ImuGrade::tactical}) {
    const auto all = errors_of(grade);
    double bias2 = 0, scale2 = 0, walk2 = 0, force_bias2 = 0, force_walk2 = 0;
    for (std::uint64_t seed = 1; seed <= units; ++seed) {
      ImuErrors bias, scale, walk;
      bias.gyroscope_bias_rad_s = all.gyroscope_bias_rad_s;
      bias.accelerometer_bias_m_s2 = all.accelerometer_bias_m_s2;
      scale.gyroscope_scale = all.gyroscope_scale;
      walk.noise.gyroscope_walk_rad_s2_sqrt_hz = all.noise.gyroscope_walk_rad_s2_sqrt_hz;
      walk.noise.accelerometer_walk_m_s3_sqrt_hz = all.noise.accelerometer_walk_m_s3_sqrt_hz;
      const auto last = [&](const auto& motion, const ImuErrors& errors) {
        return simulate_imu(motion, duration_s, 0, {.errors = errors, .rate_hz = rate_hz}, seed).samples.back();
      };
      const InertialSample at_rest = last(still, {}), turns = last(turning, {});
      const auto biased = last(still, bias), scaled = last(turning, scale), walked = last(still, walk);
      bias2 += (biased.angular_rate_rad_s - at_rest.angular_rate_rad_s).squaredNorm();
      force_bias2 += (biased.specific_force_m_s2 - at_rest.specific_force_m_s2).squaredNorm();
      scale2 +=
          (scaled.angular_rate_rad_s - turns.angular_rate_rad_s).squaredNorm() / turns.angular_rate_rad_s.squaredNorm();
      walk2 += (walked.angular_rate_rad_s - at_rest.angular_rate_rad_s).squaredNorm();
      force_walk2 += (walked.specific_force_m_s2 - at_rest.specific_force_m_s2).squaredNorm();
    }
    const auto share = [&](double squared, double sigma, double axes) {
      return std::sqrt(squared / (axes * units)) / sigma;
    };
    EXPECT_NEAR(share(bias2, all.gyroscope_bias_rad_s, 3), 1, 0.2);
    EXPECT_NEAR(share(force_bias2, all.accelerometer_bias_m_s2, 3), 1, 0.2);
    EXPECT_NEAR(share(scale2, all.gyroscope_scale, 1), 1, 0.25);
    EXPECT_NEAR(share(walk2, all.noise.gyroscope_walk_rad_s2_sqrt_hz * std::sqrt(duration_s), 3), 1, 0.2);
    EXPECT_NEAR(share(force_walk2, all.noise.accelerometer_walk_m_s3_sqrt_hz * std::sqrt(duration_s), 3), 1, 0.2);
  }
}

TEST(Imu, its_clock_may_be_ahead) {
  const auto turning = [](double t) -> Pose {
    Pose T = Pose::Identity();
    T.linear() = rotation_from_rpy(0, 0, 0.5 * t * t);  // t rad/s
    return T;
  };
  const auto record = simulate_imu(turning, 2, 50, {.errors = {}, .rate_hz = 100, .time_offset_s = 0.3}, 1);
  const auto& sample = record.samples[150];
  EXPECT_NEAR(sample.time_s, 51.5, 1e-9);
  EXPECT_NEAR(sample.angular_rate_rad_s.norm(), 1.2, 1e-6);
}

}  // namespace
}  // namespace bole::sim
