#include "slam/core/map/distribution_map.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <numbers>
#include <random>

namespace bole::slam {
namespace {

const Eigen::Vector3d far_away(431.0, -275.0, 12.0);

std::vector<Eigen::Vector3d> points_on_plane(const Eigen::Vector3d& normal, double noise_m, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> across(-0.3, 0.3);
  std::normal_distribution<double> along;
  const Eigen::Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 4000; ++i)
    points.push_back(far_away + across(random) * u + across(random) * v + noise_m * along(random) * normal);
  return points;
}

TEST(DistributionMap, GivesNormalMeanAndThicknessOfAPlane) {
  const Eigen::Vector3d normal = Eigen::Vector3d(0.3, -0.5, 0.8).normalized();
  DistributionMap map(0.1);
  for (const auto& p : points_on_plane(normal, 0.01, 3)) map.insert(p);
  const auto s = map.surface(far_away, 0);
  ASSERT_TRUE(s);
  EXPECT_GT(std::abs(s->axes.col(0).dot(normal)), 0.99);
  EXPECT_NEAR((s->mean - far_away).dot(normal), 0, 0.003);
  EXPECT_NEAR(s->deviations[0], 0.01, 0.003);
  EXPECT_GT(s->planarity(), 0.5);
}

TEST(DistributionMap, GivesTheDirectionOfALine) {
  DistributionMap map(0.1);
  const Eigen::Vector3d direction = Eigen::Vector3d(1, 2, -1).normalized();
  for (int i = -200; i <= 200; ++i) map.insert(far_away + 0.002 * i * direction);
  const auto s = map.surface(far_away, 1);
  ASSERT_TRUE(s);
  EXPECT_GT(std::abs(s->axes.col(2).dot(direction)), 0.999);
  EXPECT_GT(s->linearity(), 0.95);
}

TEST(DistributionMap, TheOrderOfPointsDoesNotMatterBelowTheCap) {
  auto points = points_on_plane(Eigen::Vector3d::UnitZ(), 0.01, 5);
  points.resize(DistributionMap::max_per_cell);
  DistributionMap a(0.1), b(0.1);
  for (const auto& p : points) a.insert(p);
  std::ranges::reverse(points);
  for (const auto& p : points) b.insert(p);
  for (int level = 0; level < DistributionMap::levels; ++level) {
    EXPECT_EQ(a.cells(level), b.cells(level));
    const auto sa = a.surface(far_away, level), sb = b.surface(far_away, level);
    ASSERT_EQ(sa.has_value(), sb.has_value());
    if (!sa) continue;
    EXPECT_EQ(sa->points, sb->points);
    EXPECT_LT((sa->mean - sb->mean).norm(), 1e-5);
  }
}

TEST(DistributionMap, ACellSettlesAtItsCap) {
  DistributionMap map(0.1);
  for (int i = 0; i < 3 * DistributionMap::max_per_cell; ++i) map.insert(Eigen::Vector3d(0.05, 0.05, 0.05));
  EXPECT_EQ(map.surface(Eigen::Vector3d(0.05, 0.05, 0.05), 0)->points, DistributionMap::max_per_cell);
}

// What a trunk looks like to the points that make it: with a window about each point the mean of the surface lies
// inside the bark, all the same from where one looks. In fixed cells the distances cancel.
TEST(DistributionMap, FixedCellsDoNotLieInsideTheBark) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> angle(0, 2 * std::numbers::pi), height(0, 2);
  std::vector<Eigen::Vector3d> points, outward;
  for (int i = 0; i < 20000; ++i) {
    const double a = angle(random);
    outward.emplace_back(std::cos(a), std::sin(a), 0);
    points.push_back(0.12 * outward.back() + Eigen::Vector3d(0.03, 0.06, height(random)));
  }
  DistributionMap map(0.1);
  DistributionMap::CellNumbers cells;
  map.insert(points, {}, &cells);
  const auto before_surface_m = [&](std::size_t i, const LocalSurface& s) {
    const double side = s.axes.col(0).dot(outward[i]) < 0 ? -1 : 1;
    return side * s.axes.col(0).dot(points[i] - s.mean);
  };
  double about_m = 0, in_cell_m = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    about_m += before_surface_m(i, *map.surface(points[i], 0));
    auto s = map.cell_surface(0, cells[0][i]);
    if (!s) continue;
    s->mean += map.centre_at(map.half_cell(points[i]), 0);
    in_cell_m += before_surface_m(i, *s);
  }
  const auto n = static_cast<double>(points.size());
  EXPECT_GT(about_m / n, 0.005);
  EXPECT_LT(std::abs(in_cell_m / n), 0.001);
}

TEST(DistributionMap, KnowsNothingWhereNothingIs) {
  DistributionMap map(0.1);
  EXPECT_TRUE(map.empty());
  EXPECT_FALSE(map.surface(far_away, 0));
  for (const auto& p : points_on_plane(Eigen::Vector3d::UnitZ(), 0, 1)) map.insert(p);
  EXPECT_FALSE(map.surface(Eigen::Vector3d(far_away + Eigen::Vector3d(50, 0, 0)), DistributionMap::levels - 1));
  map.clear();
  EXPECT_TRUE(map.empty());
}

}  // namespace
}  // namespace bole::slam
