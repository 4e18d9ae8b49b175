#include "slam/core/loops/scan_context.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "slam/core/loops/context_index.h"

namespace bole::slam {
namespace {

// Posts of different heights about a place.
std::vector<Eigen::Vector3f> posts(unsigned seed, int count = 60) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> at(-30, 30), height(0.5f, 8);
  std::vector<Eigen::Vector3f> points;
  for (int i = 0; i < count; ++i) {
    const float x = at(random), y = at(random), top = height(random);
    for (float z = -1.5f; z < top; z += 0.25f) points.emplace_back(x, y, z);
  }
  return points;
}

std::vector<Eigen::Vector3f> moved(std::vector<Eigen::Vector3f> points, double turn_rad, double dx, double dy) {
  const Eigen::AngleAxisf R(static_cast<float>(turn_rad), Eigen::Vector3f::UnitZ());
  for (auto& p : points) p = R * p + Eigen::Vector3f(static_cast<float>(dx), static_cast<float>(dy), 0);
  return points;
}

TEST(ScanContext, HoldsTheGreatestHeightOfACellOverTwoMetresBelowTheSensor) {
  const auto c = make_scan_context({{5, 0.1f, 1}, {5.1f, 0.1f, 3}, {-15, -0.1f, -1.5f}, {60, 0, 9}}, {});
  EXPECT_FLOAT_EQ(c.polar(2, 0), 5);            // ring of 2 m, first sector
  EXPECT_FLOAT_EQ(c.polar(7, 30), 0.5f);        // behind
  EXPECT_EQ((c.polar.array() > 0).count(), 2);  // beyond the range nothing counts
  EXPECT_FLOAT_EQ(c.ring_key[2], 1.f / 60);
}

TEST(ScanContext, ATurnIsFoundAndLeavesTheRingKeyAlone) {
  const ScanContextShape shape;
  const auto points = posts(1);
  const auto a = make_scan_context(points, shape);
  for (const int sectors : {0, 7, 31, 55}) {
    // What is seen from a sensor that has turned left by `turn` lies turned right by as much.
    const double turn = 2 * std::numbers::pi * sectors / shape.sectors;
    const auto b = make_scan_context(moved(points, -turn, 0, 0), shape);
    const auto match = match_polar(a, b);
    EXPECT_EQ(match.shift, sectors);
    EXPECT_LT(match.distance, 0.05);
    for (std::size_t i = 0; i < a.ring_key.size(); ++i) EXPECT_NEAR(a.ring_key[i], b.ring_key[i], 0.05);
  }
  EXPECT_GT(match_polar(a, make_scan_context(posts(2), shape)).distance, 0.35);
}

TEST(ScanContext, TheCartContextFindsAParallelLaneInBothDirections) {
  const ScanContextShape shape;
  const auto points = posts(3);
  const auto a = make_scan_context(points, shape);
  // The other sensor walks 6 m to the left: things lie 6 m farther to the right of it.
  const auto beside = make_scan_context(moved(points, 0, 0, -6), shape);
  const auto same = match_cart(a, beside, false);
  EXPECT_EQ(same.shift, 3);
  const auto back = make_scan_context(moved(moved(points, 0, 0, -6), std::numbers::pi, 0, 0), shape);
  const auto turned = match_cart(a, back, true);
  EXPECT_EQ(turned.shift, 3);
  EXPECT_LT(same.distance, match_polar(a, beside).distance);
  EXPECT_LT(turned.distance, 0.4);
}

TEST(ContextIndex, FindsThePlaceAgainAmongMany) {
  const ScanContextShape shape;
  std::vector<Keyframe> keyframes(41);
  for (unsigned k = 0; k < 40; ++k) keyframes[k].context = make_scan_context(posts(100 + k), shape);
  keyframes[40].context = make_scan_context(moved(posts(117), -0.6, 0.3, -0.2), shape);
  ContextIndex index(shape);
  for (std::size_t k = 0; k < 40; ++k) index.add(keyframes, k);
  const auto best = index.best(keyframes, 40, {.nearest = 10, .tau = 0.5, .cart = false});
  ASSERT_TRUE(best);
  EXPECT_EQ(best->keyframe, 17u);
  EXPECT_NEAR(Eigen::AngleAxisd(best->T_from_to.linear()).angle(), 0.6, 0.11);
  EXPECT_FALSE(index.best(keyframes, 40, {.nearest = 10, .tau = 0.001, .cart = false}));
}

}  // namespace
}  // namespace bole::slam
