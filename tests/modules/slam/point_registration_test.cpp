#include "slam/core/odometry/point_registration.h"

#include <gtest/gtest.h>

#include <random>

namespace bole::slam {
namespace {

// Ground and trunks, sampled anew for each cloud.
std::vector<Eigen::Vector3f> plot(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> at(-12, 12), turn(0, 6.2832f), up(0, 4);
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < 4000; ++i) {
    const float x = at(random), y = at(random);
    points.emplace_back(x, y, 0.05f * x);
  }
  for (int t = 0; t < 12; ++t) {
    const float x = static_cast<float>(t % 4) * 6 - 9 + static_cast<float>(t % 3),
                y = static_cast<float>(t / 4) * 7 - 8;
    for (int i = 0; i < 250; ++i) {
      const float a = turn(random);
      points.emplace_back(x + 0.2f * std::cos(a), y + 0.2f * std::sin(a), 0.05f * x + up(random));
    }
  }
  return points;
}

TEST(PointRegistration, IcpAndNdtFindAKnownMotion) {
  const Pose truth = se3_exp((Vector6d() << 0.01, -0.015, 0.05, 0.3, -0.25, 0.1).finished());
  const auto target = plot(1);
  auto source = plot(2);
  for (auto& p : source) p = (truth.inverse() * p.cast<double>()).cast<float>();
  const auto off = [&](const Pose& T) { return (T.translation() - truth.translation()).norm(); };
  const auto ndt = register_by_ndt(source, target, Pose::Identity(), 1.0);
  EXPECT_TRUE(ndt.converged);
  EXPECT_LT(off(ndt.T_target_source), 0.1);
  const auto icp = register_by_icp(source, target, ndt.T_target_source, 1.0);
  EXPECT_TRUE(icp.converged);
  EXPECT_LT(off(icp.T_target_source), 0.05);
  EXPECT_LT(Eigen::AngleAxisd(icp.T_target_source.linear().transpose() * truth.linear()).angle(), 0.005);
}

TEST(PointRegistration, WithTooFewPointsTheGuessStands) {
  const Pose guess = se3_exp((Vector6d() << 0, 0, 0.1, 1, 2, 3).finished());
  const std::vector<Eigen::Vector3f> few(5, Eigen::Vector3f(1, 2, 3));
  for (const auto& r : {register_by_icp(few, plot(1), guess, 1), register_by_ndt(plot(1), {}, guess, 1)}) {
    EXPECT_FALSE(r.converged);
    EXPECT_TRUE(r.T_target_source.isApprox(guess));
  }
}

}  // namespace
}  // namespace bole::slam
