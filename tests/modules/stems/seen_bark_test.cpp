// What an oval stem does to a circle through the part of it that was seen.
#include "stems/core/fit/seen_bark.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "base/angles.h"
#include "stems/core/fit/circle_fit.h"

namespace bole::stems {
namespace {

SeenBark arc(double degrees) {
  SeenBark seen;
  for (double at = 0.5; at < degrees; ++at) seen.add(radians(at - 90));
  return seen;
}

TEST(SeenBark, AStemSeenAllRoundLeavesNothingOpen) {
  EXPECT_NEAR(arc(360).shape_sd(), 0, 1e-6);
  double last = 0;
  for (const double degrees : {340, 300, 260, 220, 180}) {
    EXPECT_GT(arc(degrees).shape_sd(), last);
    last = arc(degrees).shape_sd();
  }
  EXPECT_EQ(arc(60).shape_sd(), 0.03);
  EXPECT_EQ(SeenBark().shape_sd(), 0.03);
}

TEST(SeenBark, OneSideThatCountsMoreIsAsIfLessWereSeen) {
  auto uneven = arc(360);
  for (int k = 0; k < 20; ++k)
    for (double at = 0.5; at < 150; ++at) uneven.add(radians(at));
  EXPECT_GT(uneven.shape_sd(), arc(320).shape_sd());
  EXPECT_LT(uneven.shape_sd(), arc(150).shape_sd());
}

// Circles through arcs of sections drawn with these spreads scatter by as much.
TEST(SeenBark, CirclesThroughOvalStemsScatterAsItSays) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> any(0, 2 * std::numbers::pi);
  for (const double degrees : {200.0, 240.0, 280.0}) {
    double squares = 0;
    constexpr int stems = 2000;
    for (int i = 0; i < stems; ++i) {
      const double oval = 0.02 * normal(random), three = 0.01 * normal(random), a = any(random), b = any(random);
      std::vector<Eigen::Vector2d> points;
      for (double at = 0.5; at < degrees; ++at) {
        const double bearing = radians(at),
                     r = 1 + oval * std::cos(2 * bearing + a) + three * std::cos(3 * bearing + b);
        points.emplace_back(r * std::cos(bearing), r * std::sin(bearing));
      }
      squares += std::pow(hyper_circle(points, {})->radius - 1, 2);
    }
    EXPECT_NEAR(std::sqrt(squares / stems) / arc(degrees).shape_sd(), 1, 0.1) << degrees;
  }
}

}  // namespace
}  // namespace bole::stems
