#include "slam/core/odometry/features.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "synthetic/scan_world.h"

namespace bole::slam {
namespace {

SlamSettings curvature_settings(Occlusion occlusion) {
  SlamOptions o;
  o.preset = Preset::loam;
  o.occlusion = occlusion;
  return resolved(o);
}

// One scan line, one degree apart, with the given range at each azimuth.
Scan one_line(const std::function<double(double azimuth_rad)>& range, int points = 120) {
  Scan scan;
  scan.line_begin = {0, static_cast<std::uint32_t>(points)};
  for (int i = 0; i < points; ++i) {
    const double a = (i - points / 2) * 0.01, r = range(a);
    scan.points.push_back({Eigen::Vector3d(r * std::cos(a), r * std::sin(a), 0).cast<float>(),
                           static_cast<float>(i) / static_cast<float>(points), static_cast<float>(r)});
  }
  return scan;
}

TEST(Scan, KeepsUsableReturnsInLinesAndOrder) {
  ScanFrame frame;
  const auto add = [&](const Eigen::Vector3f& p, std::uint16_t ring, float t, std::uint8_t echo) {
    frame.positions.push_back(p);
    frame.ring.push_back(ring);
    frame.time_offset_s.push_back(t);
    frame.intensity.push_back(1);
    frame.return_number.push_back(echo);
  };
  frame.start_time_s = 5;
  frame.end_time_s = 5.1;
  add({2, 0, 0}, 1, 0.00f, 1);
  add({3, 0, 0}, 0, 0.02f, 1);
  add({4, 0, 0}, 1, 0.05f, 1);
  add({std::numeric_limits<float>::quiet_NaN(), 0, 0}, 0, 0.06f, 1);
  add({0.1f, 0, 0}, 0, 0.07f, 1);  // the bearer
  add({900, 0, 0}, 0, 0.07f, 1);   // out of the gate
  add({5, 0, 0}, 77, 0.08f, 1);    // no such line
  add({6, 0, 0}, 0, 0.09f, 2);     // second echo
  Scan scan;
  prepare_scan(frame, {0.5, 60, 2}, scan);
  ASSERT_EQ(scan.points.size(), 3u);
  EXPECT_EQ(scan.dropped, 5u);
  EXPECT_EQ(scan.unknown_lines, 1u);
  EXPECT_EQ(scan.line(0).size(), 1u);
  EXPECT_FLOAT_EQ(scan.line(1)[1].range, 4);
  EXPECT_NEAR(scan.line(1)[1].s, 0.5, 1e-6);
}

TEST(Features, ACornerIsAnEdgeAndAWallIsAPlane) {
  // Two walls that meet at a right angle straight ahead, 5 m away.
  const Scan scan = one_line([](double a) { return 5 / (std::cos(a) + std::abs(std::sin(a))); });
  Features features;
  FeatureExtractor(curvature_settings(Occlusion::far_side)).extract(scan, features);
  ASSERT_FALSE(features.query.edges.empty());
  EXPECT_LT((features.query.edges.front().position - Eigen::Vector3f(5, 0, 0)).norm(), 0.1f);
  EXPECT_GT(features.map.planes.size(), 5u);
}

TEST(Features, TheOutlineOfATrunkIsAnEdgeForLoamAndNotForForest) {
  // A trunk of 0.2 m radius at 5 m before a wall at 12 m (SPEC A2).
  const auto trunk = [](double a) {
    const double across = 5 * std::sin(a);
    return std::abs(across) < 0.2 ? 5 * std::cos(a) - std::sqrt(0.04 - across * across) : 12 / std::cos(a);
  };
  Features loam, forest;
  FeatureExtractor(curvature_settings(Occlusion::far_side)).extract(one_line(trunk), loam);
  FeatureExtractor(curvature_settings(Occlusion::both_sides)).extract(one_line(trunk), forest);
  const auto on_outline = [](const FeaturePoint& p) { return p.position.x() < 6 && std::abs(p.position.y()) > 0.17f; };
  EXPECT_TRUE(std::ranges::any_of(loam.map.edges, on_outline));
  EXPECT_FALSE(std::ranges::any_of(forest.map.edges, on_outline));
}

TEST(Features, AmongConnectedNeighboursANarrowTrunkIsASurface) {
  // Seven returns wide: with a window of eleven each of them looks like an edge, and the line that they make is the
  // side that faces the sensor.
  const auto trunk = [](double a) {
    const double across = 5 * std::sin(a);
    return std::abs(across) < 0.16 ? 5 * std::cos(a) - std::sqrt(0.0256 - across * across) : 12 / std::cos(a);
  };
  auto settings = curvature_settings(Occlusion::both_sides);
  const auto on_trunk = [](const FeaturePoint& p) { return p.position.x() < 6; };
  Features features;
  FeatureExtractor(settings).extract(one_line(trunk), features);
  EXPECT_TRUE(std::ranges::any_of(features.map.edges, on_trunk));
  EXPECT_FALSE(std::ranges::any_of(features.map.planes, on_trunk));
  settings.features = FeatureKind::connected;
  FeatureExtractor(settings).extract(one_line(trunk), features);
  EXPECT_FALSE(std::ranges::any_of(features.map.edges, on_trunk));
  EXPECT_TRUE(std::ranges::any_of(features.map.planes, on_trunk));
}

TEST(Features, AnEmptyScanHasNone) {
  Scan scan;
  scan.line_begin = {0, 0, 0};
  Features features;
  for (const auto kind : {FeatureKind::curvature, FeatureKind::connected, FeatureKind::sampled}) {
    auto o = curvature_settings(Occlusion::both_sides);
    o.features = kind;
    FeatureExtractor(o).extract(scan, features);
    EXPECT_EQ(features.map.size() + features.query.size(), 0u);
  }
}

}  // namespace
}  // namespace bole::slam
