#include "cloud/first_sight.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "base/angles.h"
#include "synthetic/stand_cloud.h"

using namespace bole;

namespace {

using synthetic::mapped;
using synthetic::stand_cloud;
using synthetic::StandOptions;

// x, y, z -> x, z, -y: y up.
Eigen::Matrix3d y_up() {
  Eigen::Matrix3d matrix;
  matrix << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  return matrix;
}

TEST(FirstSight, AStandIsSeenAsItIs) {
  const auto sight = first_sight(stand_cloud());
  EXPECT_EQ(sight.up, 2);
  EXPECT_EQ(sight.kind, CloudKind::plot);
  EXPECT_EQ(sight.stems, 16U);
  EXPECT_NEAR(sight.stem_diameter_m, 0.25, 0.02);
  // 1.3 m of 400 points each, and what lies on the circle of them.
  EXPECT_NEAR(sight.points_per_stem, 520, 60);
  EXPECT_NEAR(sight.top_height_m, 15, 0.7);
  EXPECT_LT(sight.lean_deg, 0.5);
  EXPECT_LT(sight.duplicated_share, 0.001);
}

// Multipath of a scanner: some points a square metre lie up to 3.8 m below the ground.
TEST(FirstSight, PointsBelowTheGroundChangeNothing) {
  const auto cloud = stand_cloud();
  const auto plain = first_sight(cloud);
  auto positions = cloud.positions();
  std::mt19937 random(1);
  std::uniform_real_distribution<float> unit;
  Eigen::AlignedBox3f box;
  for (const auto& p : cloud.positions()) box.extend(p);
  const float spread = 3, gap = 0.8F, per_m2 = 4;
  const auto count = static_cast<int>(per_m2 * box.sizes().x() * box.sizes().y());
  for (int i = 0; i < count; ++i) {
    const float x = box.min().x() + box.sizes().x() * unit(random), y = box.min().y() + box.sizes().y() * unit(random);
    positions.emplace_back(x, y, box.min().z() - gap - spread * unit(random));
  }
  PointCloud noisy(std::move(positions));
  noisy.origin = cloud.origin;
  const auto sight = first_sight(noisy);
  EXPECT_EQ(sight.up, 2);
  EXPECT_NEAR(sight.top_height_m, plain.top_height_m, 0.3);
  EXPECT_NEAR(sight.stem_diameter_m, plain.stem_diameter_m, 0.02);
  EXPECT_NEAR(sight.points_per_stem, plain.points_per_stem, 40);
}

TEST(FirstSight, YOrXUpIsFound) {
  const auto cloud = stand_cloud();
  const auto y = first_sight(mapped(cloud, y_up()));
  EXPECT_EQ(y.up, 1);
  EXPECT_EQ(y.stems, 16U);
  Eigen::Matrix3d x_up;
  x_up << 0, 0, 1, 0, 1, 0, -1, 0, 0;
  EXPECT_EQ(first_sight(mapped(cloud, x_up)).up, 0);
}

TEST(FirstSight, ACloudUpsideDownIsNotDecided) {
  EXPECT_FALSE(first_sight(mapped(stand_cloud(), Eigen::Vector3d(1, -1, -1).asDiagonal())).up.has_value());
}

TEST(FirstSight, NoAxisIsTakenWithoutStems) {
  StandOptions stumps;
  stumps.height = 0.5;
  EXPECT_FALSE(first_sight(stand_cloud(stumps)).up.has_value());
}

TEST(FirstSight, TheCommonLeanIsThatOfATiltedCloud) {
  const Eigen::Matrix3d tilt = Eigen::AngleAxisd(radians(5), Eigen::Vector3d(1, 2, 0).normalized()).toRotationMatrix();
  const auto sight = first_sight(mapped(stand_cloud(), tilt));
  EXPECT_NEAR(sight.lean_deg, 5, 0.2);
  EXPECT_LT(sight.lean_error_deg, 0.3);
}

TEST(FirstSight, TwoWallsOfTheStemsAreSeen) {
  EXPECT_EQ(first_sight(stand_cloud()).doubled_by_m, 0);
  StandOptions noisy;
  noisy.noise = 0.025;
  EXPECT_EQ(first_sight(stand_cloud(noisy)).doubled_by_m, 0);
  auto points = stand_cloud().positions();
  for (std::size_t i = 0; i < points.size(); i += 2) points[i] += Eigen::Vector3f(0.05F, 0, 0);
  const auto sight = first_sight(PointCloud(points));
  EXPECT_NEAR(sight.doubled_by_m, 0.05, 0.01);
  EXPECT_NEAR(sight.doubled_bearing_deg, 90, 8);
}

TEST(FirstSight, TwoWallsAreSeenAmongTwigs) {
  StandOptions noisy;
  noisy.noise = 0.012;
  auto points = stand_cloud(noisy).positions();
  std::mt19937 random(4);
  std::uniform_real_distribution<float> twig(-0.3F, 0.3F);
  for (std::size_t i = 0, n = points.size(); i < n; i += 8)
    points.push_back(points[i] + Eigen::Vector3f(twig(random), twig(random), twig(random)));
  EXPECT_EQ(first_sight(PointCloud(points)).doubled_by_m, 0);
  for (std::size_t i = 0; i < points.size(); i += 2) points[i] += Eigen::Vector3f(0.05F, 0, 0);
  EXPECT_NEAR(first_sight(PointCloud(points)).doubled_by_m, 0.05, 0.015);
}

TEST(FirstSight, SparseStemsAreCounted) {
  StandOptions o;
  o.points_per_metre = 20;
  const auto sight = first_sight(stand_cloud(o));
  EXPECT_GE(sight.stems, 8U);
  EXPECT_NEAR(sight.points_per_stem, 26, 8);
  EXPECT_LT(sight.points_per_stem, needed_points_per_stem);
}

TEST(FirstSight, RepeatedPointsAreCounted) {
  auto points = stand_cloud().positions();
  const std::size_t n = points.size();
  points.insert(points.end(), points.begin(), points.begin() + static_cast<std::ptrdiff_t>(n / 4));
  EXPECT_NEAR(first_sight(PointCloud(points)).duplicated_share, 0.2, 0.01);
}

TEST(FirstSight, ATreeThatWasCutOutIsASingleTree) {
  StandOptions o;
  o.stems = 1;
  o.ground_points_per_m2 = 0;
  const auto tree = first_sight(stand_cloud(o));
  EXPECT_EQ(tree.kind, CloudKind::single_tree);
  // With the ground around it is none, because its ground can be seen.
  o.ground_points_per_m2 = 200;
  EXPECT_NE(first_sight(stand_cloud(o)).kind, CloudKind::single_tree);
}

TEST(FirstSight, TheCornerOfASteepPlotIsNoSingleTree) {
  StandOptions o;
  o.slope = 0.8;
  EXPECT_NE(
      first_sight(mapped(stand_cloud(o), Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()).toRotationMatrix())).kind,
      CloudKind::single_tree);
}

TEST(FirstSight, FewOrNoPointsAreNoError) {
  EXPECT_EQ(first_sight(PointCloud()).points, 0U);
  EXPECT_EQ(first_sight(PointCloud({{0, 0, 0}, {1, 1, 1}})).kind, CloudKind::unknown);
  EXPECT_EQ(first_sight(PointCloud(PointCloud::Positions(200, Eigen::Vector3f(1, 2, 3)))).stems, 0U);
}

}  // namespace
