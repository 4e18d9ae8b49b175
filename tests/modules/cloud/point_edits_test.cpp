// Selections of points by geometry, against looking at every point in the plainest way.
#include "cloud/core/regions/point_edits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "checks.h"

namespace bole {
namespace {

using testing::HasSubstr;
using testing_checks::refusal_of;

// Points of a cube about (100, 200, 5), which the origin of the cloud is not in.
PointCloud cube(std::size_t n = 20'000) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> u(-3, 3);
  PointCloud::Positions all;
  for (std::size_t i = 0; i < n; ++i) all.emplace_back(u(random), u(random), u(random));
  return PointCloud(all, {100, 200, 5});
}

template <class Inside>
void expect_the_same(const PointRegion& region, const Inside& inside) {
  const auto cloud = cube();
  const RegionTest test(region);
  std::size_t held = 0, wrong = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d p = cloud.position(i);
    const bool is = inside(p);
    held += is ? 1 : 0;
    wrong += test.contains(p) != is ? 1 : 0;
  }
  EXPECT_EQ(wrong, 0U);
  EXPECT_GT(held, 20U);
  EXPECT_LT(held, cloud.size() / 2);
}

PointRegion edit_region(const std::string& keys) {
  return parse_point_edits(R"([{"action": "to_noise", )" + keys + "}]")[0].region;
}

TEST(PointRegion, ABoxTurnsAboutItsMiddle) {
  const auto region = edit_region(R"("centre": [100.5, 200, 5], "size_m": [4, 1, 2], "turn_deg": 30)");
  const Eigen::Matrix2d back = Eigen::Rotation2Dd(-M_PI / 6).toRotationMatrix();
  expect_the_same(region, [&](const Eigen::Vector3d& p) {
    const Eigen::Vector2d q = back * (p.head<2>() - Eigen::Vector2d(100.5, 200));
    return std::abs(q.x()) <= 2 && std::abs(q.y()) <= 0.5 && std::abs(p.z() - 5) <= 1;
  });
}

TEST(PointRegion, ABrushHoldsWhatIsNearItsStroke) {
  const auto region = edit_region(R"("path": [[99, 199, 4], [101, 200, 5], [101, 202, 7]], "radius_m": 0.7)");
  // Balls so close together that nothing is missed but by rounding.
  expect_the_same(region, [&](const Eigen::Vector3d& p) {
    double nearest = 1e9;
    for (std::size_t k = 1; k < region.path.size(); ++k)
      for (double t = 0; t <= 1; t += 1e-4)
        nearest = std::min(nearest, (region.path[k - 1] + t * (region.path[k] - region.path[k - 1]) - p).norm());
    return nearest <= 0.7;
  });
  expect_the_same(edit_region(R"("path": [[100, 200, 5]], "radius_m": 2)"),
                  [](const Eigen::Vector3d& p) { return (p - Eigen::Vector3d(100, 200, 5)).norm() <= 2; });
}

TEST(PointRegion, AnOutlineWithoutAnEyeIsAPrism) {
  // A triangle in the plane y = 200, seen along y.
  const auto triangle = [](const Eigen::Vector3d& p) {
    return p.z() > 4 && p.x() - 99 > (p.z() - 4) / 2 && 101 - p.x() > (p.z() - 4) / 2;
  };
  const std::string corners = R"("outline": [[99, 200, 4], [101, 200, 4], [100, 200, 6]])";
  expect_the_same(edit_region(corners), triangle);
  // Corners run anti-clockwise as seen from small y: depth is positive there.
  expect_the_same(edit_region(corners + R"(, "depth_m": [-0.5, 2])"),
                  [&](const Eigen::Vector3d& p) { return triangle(p) && p.y() <= 200.5 && p.y() >= 198; });
  expect_the_same(edit_region(corners + R"(, "within": [[90, 190, 0], [100, 210, 5]])"),
                  [&](const Eigen::Vector3d& p) { return triangle(p) && p.x() <= 100 && p.z() <= 5; });
}

TEST(PointRegion, AnOutlineWithAnEyeIsACone) {
  const Eigen::Vector3d eye(100, 195, 5);
  // A concave outline, one metre before the eye.
  const auto region = edit_region(
      R"("outline": [[99.7, 196, 4.8], [100.3, 196, 4.8], [100.3, 196, 5.3], [100, 196, 4.9], [99.7, 196, 5.3]],
         "eye": [100, 195, 5])");
  expect_the_same(region, [&](const Eigen::Vector3d& p) {
    const Eigen::Vector3d d = (p - eye) / (p.y() - eye.y());
    if (p.y() <= eye.y() || std::abs(d.x()) > 0.3 || d.z() < -0.2) return false;
    return d.z() < -0.1 + 0.4 * std::abs(d.x()) / 0.3;
  });
}

TEST(PointRegion, AThinnedCloudGivesTheSameSubset) {
  const auto cloud = cube();
  std::vector<std::uint32_t> every_third;
  for (std::uint32_t i = 0; i < cloud.size(); i += 3) every_third.push_back(i);
  const auto thin = cloud.subset(every_third);
  const auto region = edit_region(R"("path": [[99, 199, 4], [101, 200, 5]], "radius_m": 0.9)");
  std::vector<std::size_t> expected;
  for (const auto i : points_in(region, cloud))
    if (i % 3 == 0) expected.push_back(i / 3);
  EXPECT_EQ(points_in(region, thin), expected);
}

TEST(PointEdits, AListComesBack) {
  const std::string text = R"([
    {"action": "to_tree", "tree": [3.25, 27.5], "path": [[3, 27.5, 8], [3.5, 27, 8.5]], "radius_m": 0.25,
     "only_free": true, "author": "A. Smith", "time": "2026-05-02T10:15:00Z", "reason": "a branch"},
    {"action": "to_no_tree", "centre": [1, 2, 3], "size_m": [2, 4, 6], "turn_deg": 15, "only_tree": [3, 27]},
    {"action": "to_ground", "outline": [[0, 0, 0], [1, 0, 0], [0, 1, 0]], "eye": [0, 0, 5], "depth_m": [-1, 2]},
    {"action": "to_noise", "path": [[0, 0, 0]], "radius_m": 1, "within": [[0, 0, 0], [1, 1, 1]]},
    {"action": "to_no_tree", "path": [[0, 0, 0]], "radius_m": 1, "only_class": 5}])";
  const auto edits = parse_point_edits(text);
  ASSERT_EQ(edits.size(), 5U);
  EXPECT_EQ(edits[0].author, "A. Smith");
  EXPECT_EQ(edits[1].region.turn_deg, 15);
  EXPECT_EQ(edits[2].region.depth, Eigen::Vector2d(-1, 2));
  EXPECT_EQ(edits[4].only_class, 5);
  const auto again = to_json(edits);
  EXPECT_EQ(to_json(parse_point_edits(again)), again);
  for (const char* key : {"only_free", "turn_deg", "depth_m", "within", "eye", "only_class", "only_tree"})
    EXPECT_THAT(again, HasSubstr(key));
  const auto table = point_edit_table(edits, cube(), {});
  EXPECT_EQ(to_json(point_edits_in(table)), again);
}

std::string refusal(const std::string& keys) {
  return refusal_of([&] { parse_point_edits("[" + keys + "]"); });
}

TEST(PointEdits, WhatCannotBeMeantIsRefused) {
  const auto outline = [](const std::string& corners) {
    return refusal(R"({"action": "to_noise", "outline": )" + corners + "}");
  };
  EXPECT_THAT(outline("[[0, 0, 0], [1, 0, 0]]"), HasSubstr("at least 3"));
  EXPECT_THAT(outline("[[0, 0, 0], [1, 0, 0], [2, 0, 0]]"), HasSubstr("on one line"));
  EXPECT_THAT(outline("[[0, 0, 0], [2, 2, 0], [2, 0, 0], [0, 1, 0]]"), HasSubstr("crosses itself"));
  EXPECT_THAT(outline("[[0, 0, 0], [1e300, 0, 0], [0, 1, 0]]"), HasSubstr("outline is 1e+300"));
  EXPECT_THAT(outline("[[0, 0, null], [1, 0, 0], [0, 1, 0]]"), HasSubstr("outline is null"));
  EXPECT_THAT(refusal(R"({"action": "to_noise", "path": [[0, 0, 0]], "radius_m": 0})"), HasSubstr("radius_m is 0"));
  EXPECT_THAT(refusal(R"({"action": "to_noise", "centre": [0, 0, 0], "size_m": [1, -1, 1]})"), HasSubstr("size_m"));
  EXPECT_THAT(refusal(R"({"action": "to_noise", "centre": [0, 0, 0]})"), HasSubstr("which points"));
  EXPECT_THAT(refusal(R"({"action": "to_tree", "path": [[0, 0, 0]], "radius_m": 1})"), HasSubstr("without tree"));
  EXPECT_THAT(refusal(R"({"action": "to_noise", "path": [[0, 0, 0]], "radius_m": 1, "only_free": true})"),
              HasSubstr("does not take 'only_free'"));
  EXPECT_THAT(refusal(R"({"action": "to_leaf"})"), HasSubstr("to_ground, to_noise"));
}

TEST(PointEdits, TheLastEditOfAPointGivesItsClass) {
  const PointCloud cloud(PointCloud::Positions{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}});
  const auto classes = [&](const std::string& list) { return given_classes(cloud, parse_point_edits(list), {}); };
  const std::string noise = R"({"action": "to_noise", "path": [[0, 0, 0], [2, 0, 0]], "radius_m": 0.1})",
                    ground = R"({"action": "to_ground", "path": [[1, 0, 0]], "radius_m": 0.1})",
                    back = R"({"action": "to_no_tree", "path": [[2, 0, 0]], "radius_m": 0.1})";
  EXPECT_THAT(classes("[" + noise + "," + ground + "," + back + "]"), testing::ElementsAre(7, 2, 0, 0));
  EXPECT_THAT(classes("[" + back + "," + ground + "," + noise + "]"), testing::ElementsAre(7, 7, 7, 0));
  EXPECT_TRUE(classes("[" + back + "]").empty());
}

}  // namespace
}  // namespace bole
