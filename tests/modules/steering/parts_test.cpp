// Receiver, filter, controller, tractor and turn, each against what is known of it.
#include <gtest/gtest.h>

#include <cmath>

#include "base/angles.h"
#include "steering/core/guidance_line.h"
#include "steering/core/headland_turn.h"
#include "steering/core/position_velocity_filter.h"
#include "steering/core/preview_pid.h"
#include "steering/core/receiver.h"
#include "steering/core/tractor.h"

namespace bole::steering {
namespace {

TEST(Receiver, HasTheNoiseAndTheCorrelationItIsGiven) {
  ReceiverOptions o;
  o.white_noise = 0;
  o.drift = 0.02;
  o.drift_time = 5;
  Receiver receiver(o, 3);
  std::vector<double> x;
  for (int i = 0; i < 200'000; ++i) x.push_back(receiver.fix({100, 0})->x() - 100);
  double variance = 0, covariance = 0;
  for (std::size_t i = 50; i < x.size(); ++i) {
    variance += x[i] * x[i];
    covariance += x[i] * x[i - 50];
  }
  EXPECT_NEAR(std::sqrt(variance / static_cast<double>(x.size())), 0.02, 0.002);
  EXPECT_NEAR(covariance / variance, std::exp(-1), 0.05);  // 50 fixes are one correlation time
}

TEST(Receiver, LosesFixesForTheShareOfTimeItIsTold) {
  ReceiverOptions o;
  o.outages_per_hour = 60;
  o.outage_length = 4;
  Receiver receiver(o, 1);
  int lost = 0;
  for (int i = 0; i < 300'000; ++i) lost += receiver.fix({0, 0}) ? 0 : 1;
  EXPECT_NEAR(lost / 300'000.0, 60 * 4 / 3600.0, 0.02);
}

TEST(Filter, FollowsAUniformMotionWithoutLagAndSmoothsNoise) {
  PositionVelocityFilter filter(FilterOptions{});
  filter.start({0, 0}, {0, 0});
  Random random(1, 9);
  double squares = 0;
  for (int i = 1; i <= 2000; ++i) {
    const Eigen::Vector2d truth(0.2 * i, -0.1 * i);
    filter.step(0.1, truth + 0.01 * Eigen::Vector2d(random.normal(), random.normal()));
    if (i > 200) squares += (filter.position() - truth).squaredNorm() / 2;
  }
  EXPECT_LT(std::sqrt(squares / 1800), 0.009);
  EXPECT_NEAR(filter.velocity().x(), 2, 0.05);
  EXPECT_NEAR(filter.velocity().y(), -1, 0.05);
}

TEST(Filter, LeavesOutASpikeAndBelievesAStepThatStays) {
  const FilterOptions o;
  PositionVelocityFilter filter(o);
  filter.start({0, 0}, {1, 0});
  double x = 0;
  const auto go = [&](double jump) { filter.step(0.1, Eigen::Vector2d(x += 0.1, jump)); };
  for (int i = 0; i < 50; ++i) go(0);
  go(1);
  EXPECT_LT(std::abs(filter.position().y()), 0.01);
  EXPECT_TRUE(filter.doubts());
  for (int i = 0; i < 20; ++i) go(0);
  EXPECT_FALSE(filter.doubts());
  for (double t = 0; t <= o.patience + 0.2; t += 0.1) go(1);
  EXPECT_NEAR(filter.position().y(), 1, 0.02);
  EXPECT_NEAR(filter.velocity().y(), 0, 0.1);
}

TEST(Filter, CountsTheTimeWithoutFixes) {
  PositionVelocityFilter filter(FilterOptions{});
  filter.start({0, 0}, {2, 0});
  for (int i = 0; i < 30; ++i) filter.step(0.1, std::nullopt);
  EXPECT_NEAR(filter.seconds_without_fix(), 3, 1e-9);
  EXPECT_NEAR(filter.position().x(), 6, 1e-9);
  EXPECT_GT(filter.position_sigma().x(), 0.5);
}

TEST(PreviewPid, HasThePublishedTableAndStraightLinesBetween) {
  const auto g = published_gains(3);
  EXPECT_EQ(g.preview_m, 1.4);
  EXPECT_EQ(g.p, 170);
  EXPECT_EQ(g.i, 13);
  EXPECT_EQ(g.d, 39);
  EXPECT_NEAR(published_gains(6).p, 140, 1e-9);
  EXPECT_EQ(published_gains(20).d, 22);
}

TEST(PreviewPid, SteersByTheEquationOfThePaper) {
  ControlOptions o;
  o.max_command_deg = 40;
  const Gains g{2, 100, 0, 30};
  PreviewPid pid(o, g);
  const double alpha = 3 * rad_per_deg, expected = -(100 * (0.05 + 2 * std::sin(alpha)) + 30 * 1.5 * std::tan(alpha));
  EXPECT_NEAR(pid.wheel_angle_rad(0.05, alpha, 1.5, 0.1) / rad_per_deg, expected, 1e-9);
  // Left of the line steers right, and the integral goes on asking.
  PreviewPid with_integral(o, {2, 0, 10, 0});
  for (int i = 0; i < 10; ++i) with_integral.wheel_angle_rad(0.1, 0, 1, 0.1);
  EXPECT_NEAR(with_integral.wheel_angle_rad(0, 0, 1, 0.1) / rad_per_deg, -1, 1e-9);
}

TEST(Tractor, DrivesTheCircleOfItsWheelAngle) {
  TractorOptions o;
  o.steering_offset_deg = o.wheel_disturbance_deg = 0;
  Tractor tractor(o, 0, 1);
  tractor.place({0, 0}, 0, 2);
  for (int i = 0; i < 50; ++i) tractor.advance(0.1, 20 * rad_per_deg, 2);  // the wheels have turned
  EXPECT_NEAR(tractor.wheel_rad(), 20 * rad_per_deg, 1e-6);
  const auto before = tractor.attitude().yaw_rad;
  for (int i = 0; i < 10; ++i) tractor.advance(0.1, 20 * rad_per_deg, 2);
  EXPECT_NEAR(tractor.attitude().yaw_rad - before, 2 * std::tan(20 * rad_per_deg) / o.wheelbase, 1e-6);
}

TEST(Tractor, SlipsDownhill) {
  TractorOptions o;
  o.steering_offset_deg = o.wheel_disturbance_deg = 0;
  o.side_slope_deg = 10;
  o.slip_per_slope = 0.1;
  Tractor tractor(o, 0, 1);
  tractor.place({0, 0}, 0, 1);
  for (int i = 0; i < 100; ++i) tractor.advance(0.1, 0, 1);
  EXPECT_NEAR(tractor.rear_axle().y(), -10 * std::tan(1 * rad_per_deg), 1e-3);
  o.roughness_deg = 0;
  Tractor still(o, 0, 1);
  EXPECT_NEAR(still.attitude().roll_rad, 10 * rad_per_deg, 1e-9);  // the right side is lower
}

TEST(HeadlandTurn, EndsOnTheNextLineTheOtherWay) {
  for (const double shift : {2.5, -2.5, 6.0, 12.0, 20.0}) {
    Eigen::Vector2d p = Eigen::Vector2d::Zero();
    double yaw = 0;
    for (const auto& arc : headland_turn(shift, 6))
      for (int i = 0; i < 10'000; ++i) {
        const double step = arc.length_m / 10'000;
        yaw += arc.curvature * step / 2;
        p += step * Eigen::Vector2d(std::cos(yaw), std::sin(yaw));
        yaw += arc.curvature * step / 2;
      }
    EXPECT_NEAR(p.x(), 0, 1e-3) << shift;
    EXPECT_NEAR(p.y(), shift, 1e-3) << shift;
    EXPECT_NEAR(std::cos(yaw), -1, 1e-9) << shift;
  }
}

}  // namespace
}  // namespace bole::steering
