#include "base/transform.h"

#include <gtest/gtest.h>

#include <random>

namespace bole {
namespace {

TEST(Transform, ExponentialAndLogarithmAreInverse) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1.5, 1.5);
  for (int i = 0; i < 100; ++i) {
    Vector6d twist;
    for (int k = 0; k < 6; ++k) twist[k] = uniform(random);
    EXPECT_LT((se3_log(se3_exp(twist)) - twist).norm(), 1e-12);
  }
  EXPECT_LT((se3_log(se3_exp(Vector6d::Constant(1e-9))) - Vector6d::Constant(1e-9)).norm(), 1e-18);
}

TEST(Transform, InterpolationMeetsItsEnds) {
  const Pose a = se3_exp((Vector6d() << 0.1, 0.2, -0.3, 1, 2, 3).finished());
  const Pose b = se3_exp((Vector6d() << -0.4, 0.5, 0.6, 4, 5, 6).finished());
  EXPECT_TRUE(interpolate(a, b, 0).isApprox(a, 1e-12));
  EXPECT_TRUE(interpolate(a, b, 1).isApprox(b, 1e-12));
  const Pose middle = interpolate(a, b, 0.5);
  const Eigen::Quaterniond qa(a.linear()), qb(b.linear()), qm(middle.linear());
  EXPECT_NEAR(qa.angularDistance(qm), qm.angularDistance(qb), 1e-12);
}

}  // namespace
}  // namespace bole
