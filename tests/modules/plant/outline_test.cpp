// Sizes of a leaf by its outlines in pictures, where its cloud lacks a part or has points beside it.
#include "plant/core/traits/outline.h"

#include <gmock/gmock.h>

#include "leaf_views.h"

namespace bole::plant {
namespace {

Points3 table() {
  Points3 out;
  for (double x = -0.3; x < 0.3; x += 0.004)
    for (double y = -0.3; y < 0.3; y += 0.004) out.emplace_back(x, y, -0.1);
  return out;
}

Outline outline_of(const Points3& points, const LeafViews& views) {
  const auto others = table();
  return measure_outline({&views, &views.given_poses(), Pose::Identity(), &points, &others, 0.0005}, all_of(views), {});
}

// Of the leaf itself.
PlanRectangle true_rectangle() {
  return smallest_rectangle({{half_length, 0}, {0, half_width}, {-half_length, 0}, {0, -half_width}});
}

TEST(Outline, IsThatOfTheLeafThoughTheCloudEndsInItsMiddle) {
  const LeafViews views;
  auto points = leaf_cloud(1, 0.0001);
  std::erase_if(points, [](const Eigen::Vector3d& p) { return p.x() > 0.01; });
  const auto outline = outline_of(points, views);
  ASSERT_TRUE(outline.told);
  const auto truth = true_rectangle();
  // Two sides, each to a cell of the masks: 0.4 mm here.
  EXPECT_NEAR(outline.length.value, truth.length, 0.002);
  EXPECT_NEAR(outline.width.value, truth.width, 0.002);
  EXPECT_LT(std::abs(outline.length.value - truth.length), 2 * outline.length.sd);
  EXPECT_TRUE(outline.length_measured);
  // All cameras look down on it: there is room above.
  EXPECT_GT(outline.top.value, 0.198);
  EXPECT_FALSE(outline.top_measured);
  EXPECT_LT(outline.length.sd, 0.0025);
  EXPECT_LT(outline.refuted, 0.002);
}

TEST(Outline, APieceThatNothingConnectsIsNotThePlantsButTold) {
  constexpr double gap = 0.02;
  const LeafViews views(false, gap);
  auto points = leaf_cloud(1, 0.0001);
  std::erase_if(points, [](const Eigen::Vector3d& p) { return p.x() > 0; });
  const auto outline = outline_of(points, views);
  ASSERT_TRUE(outline.told);
  EXPECT_NEAR(outline.length.value, half_length, 0.003);
  // The far tip is thinner than a cell.
  EXPECT_GT(outline.with_loose.length, 1.8 * half_length);
  EXPECT_LT(outline.with_loose.length, 2.05 * half_length);
  // Without a gap all of the leaf is connected.
  EXPECT_NEAR(outline_of(points, LeafViews()).with_loose.length, outline_of(points, LeafViews()).length.value, 1e-9);
}

TEST(Outline, PointsBesideTheLeafAreRefuted) {
  const LeafViews views;
  auto points = leaf_cloud(1, 0.0001);
  const auto on_it = points.size();
  // Drawn out from the tip along the line of sight of one camera, as points at the edges of depth are.
  const auto eye = views.given_poses().poses.front().T_target_sensor.translation();
  const Eigen::Vector3d tip(half_length - 0.002, 0, 0.2), way = (tip - eye).normalized();
  for (int k = 0; k < 200; ++k) points.push_back(tip + (0.012 + 0.0001 * k) * way);
  const auto outline = outline_of(points, views);
  ASSERT_TRUE(outline.told);
  EXPECT_NEAR(static_cast<double>(outline.points.size()), static_cast<double>(on_it), 30);
  EXPECT_NEAR(outline.refuted, 200.0 / static_cast<double>(points.size()), 0.005);
}

TEST(Outline, IsNotToldBeforeTheColoursOfThePlant) {
  const LeafViews views(true);
  const auto points = leaf_cloud(1, 0.0001);
  const auto outline = outline_of(points, views);
  EXPECT_FALSE(outline.told);
  EXPECT_EQ(outline.points.size(), points.size());
}

}  // namespace
}  // namespace bole::plant
