#include "stems/core/fit/circle_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace bole::stems {
namespace {

// The guess is for speed alone.
TEST(QuickMedian, IsTheSameWhateverTheGuess) {
  for (std::size_t n = 0; n < 40; ++n) {
    std::vector<double> values;
    for (std::size_t i = 0; i < n; ++i) values.push_back(static_cast<double>((7 * i * i + 3 * i) % 11));
    auto sorted = values;
    std::ranges::sort(sorted);
    for (const double guess : {0.0, 1.0, 4.0, 5.5, 100.0, -3.0, std::nan("")}) {
      auto copy = values;
      const double found = upper_median_near(copy, guess);
      if (n == 0)
        EXPECT_TRUE(std::isnan(found));
      else
        EXPECT_EQ(found, sorted[n / 2]) << n << " values, guess " << guess;
    }
  }
}

std::vector<Eigen::Vector2d> ring(const Circle& c, double from, double to, int n, double noise, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0, 1);
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < n; ++i) {
    const double a = from + (to - from) * (i + 0.5) / n, r = c.radius + noise * normal(random);
    points.emplace_back(c.centre.x() + r * std::cos(a), c.centre.y() + r * std::sin(a));
  }
  return points;
}

TEST(HyperCircle, IsExactOnExactPoints) {
  const Circle truth{{3, -2}, 0.15};
  for (const double arc : {6.28, 3.0, 1.0}) {
    const auto found = hyper_circle(ring(truth, 0.4, 0.4 + arc, 20, 0, 1));
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->radius, 0.15, 1e-9);
    EXPECT_LT((found->centre - truth.centre).norm(), 1e-9);
  }
}

TEST(HyperCircle, HasLessBiasThanHalfAMillimetreOnAHalfRing) {
  double sum = 0;
  for (unsigned seed = 1; seed <= 200; ++seed)
    sum += hyper_circle(ring({{0, 0}, 0.15}, 0, std::numbers::pi, 100, 0.01, seed))->radius - 0.15;
  EXPECT_LT(std::abs(sum / 200), 0.0005);
}

TEST(HyperCircle, RefusesLinesAndTooFewPoints) {
  EXPECT_FALSE(hyper_circle({{0, 0}, {1, 1}}));
  EXPECT_FALSE(hyper_circle({{0, 0}, {1, 1}, {2, 2}, {3, 3}}));
  EXPECT_FALSE(hyper_circle({{1, 1}, {1, 1}, {1, 1}}));
}

TEST(RobustCircle, OutliersDoNotSwellIt) {
  auto points = ring({{1, 1}, 0.12}, 0, 6.28, 200, 0.008, 3);
  std::mt19937 random(4);
  std::uniform_real_distribution<double> u(-0.25, 0.25);
  for (int i = 0; i < 60; ++i) points.emplace_back(1 + u(random), 1 + u(random));
  const auto found = robust_circle(points, {{1.02, 0.99}, 0.10}, 0.05, 0.025);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->circle.radius, 0.12, 0.003);
  EXPECT_GT(found->arc_rad, 6.0);
}

TEST(CoveredArc, CountsTenDegreeSectors) {
  std::vector<double> angles;
  for (int i = 0; i < 9; ++i) angles.push_back((i * 10 + 5) * std::numbers::pi / 180);
  EXPECT_NEAR(covered_arc_rad(angles), std::numbers::pi / 2, 1e-12);
  EXPECT_EQ(covered_arc_rad({}), 0);
}

TEST(Arc, ClumpsHaveNoLongUnbrokenPart) {
  const auto run = [](double from_deg, double to_deg, std::vector<double>& angles) {
    for (double a = from_deg; a < to_deg; a += 5) angles.push_back(a * std::numbers::pi / 180);
  };
  std::vector<double> clumps, across_north;
  run(2, 40, clumps), run(122, 160, clumps), run(242, 280, clumps);
  EXPECT_NEAR(covered_arc_rad(clumps), 120 * std::numbers::pi / 180, 1e-9);
  EXPECT_NEAR(unbroken_arc_rad(clumps), 40 * std::numbers::pi / 180, 1e-9);
  run(-98, 102, across_north);
  EXPECT_NEAR(unbroken_arc_rad(across_north), 200 * std::numbers::pi / 180, 0.2);
  EXPECT_EQ(unbroken_arc_rad({}), 0);
}

}  // namespace
}  // namespace bole::stems
