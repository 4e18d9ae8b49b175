#include "survey/core/post_centre.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace bole::survey {
namespace {

std::vector<Eigen::Vector2d> arc(double radius_m, double from_rad, double to_rad, double noise_m, std::size_t n) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(from_rad, to_rad);
  std::normal_distribution<double> noise(0, noise_m);
  std::vector<Eigen::Vector2d> out;
  for (std::size_t i = 0; i < n; ++i) {
    const double a = angle(random), r = radius_m + noise(random);
    out.emplace_back(5 + r * std::cos(a), -3 + r * std::sin(a));
  }
  return out;
}

TEST(PostCentre, HalfACircleGivesTheAxis) {
  const auto fit = fit_post(arc(0.1, 0, std::numbers::pi, 0.02, 2000), {}, 0.35);
  ASSERT_TRUE(fit.valid);
  EXPECT_LT((fit.centre - Eigen::Vector2d(5, -3)).norm(), 0.008);
  EXPECT_NEAR(fit.radius_m, 0.1, 0.01);
}

TEST(PostCentre, APlateIsNotRound) {
  std::mt19937 random(4);
  std::uniform_real_distribution<double> along(-0.2, 0.2);
  std::normal_distribution<double> noise(0, 0.01);
  std::vector<Eigen::Vector2d> plate;
  for (int i = 0; i < 500; ++i) plate.emplace_back(along(random), noise(random));
  EXPECT_FALSE(fit_post(plate, {}, 0.35).valid);
}

TEST(PostCentre, FewOrEqualPointsAreNoCircle) {
  EXPECT_FALSE(fit_post({}, {}, 0.35).valid);
  EXPECT_FALSE(fit_post(std::vector<Eigen::Vector2d>(50, Eigen::Vector2d(1, 1)), {}, 0.35).valid);
}

}  // namespace
}  // namespace bole::survey
