#include "slam/core/odometry/priors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace bole::slam {
namespace {

TEST(Priors, ThePointCovarianceIsThatOfTheObservations) {
  const SensorPrior prior{0.03, 0.002};
  const double theta = 0.7, phi = -0.3, range = 12;
  const auto point = [](double t, double f, double d) {
    return Eigen::Vector3d(d * std::cos(f) * std::cos(t), d * std::cos(f) * std::sin(t), d * std::sin(f));
  };
  // By numeric derivatives.
  const double h = 1e-6;
  Eigen::Matrix3d M;
  M.col(0) = (point(theta + h, phi, range) - point(theta - h, phi, range)) / (2 * h);
  M.col(1) = (point(theta, phi + h, range) - point(theta, phi - h, range)) / (2 * h);
  M.col(2) = (point(theta, phi, range + h) - point(theta, phi, range - h)) / (2 * h);
  const Eigen::Matrix3d expected = M * Eigen::Vector3d(4e-6, 4e-6, 9e-4).asDiagonal() * M.transpose();
  EXPECT_TRUE(point_covariance(point(theta, phi, range), prior).isApprox(expected, 1e-6));
}

TEST(Priors, PoseVarianceIsThatOfAPointMovedByThePose) {
  Matrix6d covariance = Matrix6d::Zero();
  covariance.diagonal() << 1e-4;
  2e-4;
  3e-4;
  1e-2;
  4e-2;
  9e-2;
  covariance(0, 4) = covariance(4, 0) = 5e-4;
  const Eigen::Vector3d lever(3, -2, 1), axis = Eigen::Vector3d(1, 2, -1).normalized();
  const Eigen::LLT<Matrix6d> root(covariance);
  const Matrix6d L = root.matrixL();
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  double squared = 0;
  constexpr int samples = 40000;
  for (int i = 0; i < samples; ++i) {
    Vector6d u;
    for (int k = 0; k < 6; ++k) u[k] = normal(random);
    const Vector6d v = L * u;
    const double d = axis.dot(v.head<3>().cross(lever) + v.tail<3>());
    squared += d * d;
  }
  EXPECT_NEAR(pose_variance(axis, lever, covariance), squared / samples, 0.03 * squared / samples);
}

}  // namespace
}  // namespace bole::slam
