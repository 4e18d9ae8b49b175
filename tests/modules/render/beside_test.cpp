#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "render/beside/draped_ground.h"
#include "render/beside/ground_below.h"
#include "render/beside/placed_cloud.h"
#include "render/charts/stem_profile.h"
#include "render/charts/stem_slice.h"
#include "render/draw/cloud_key.h"
#include "render/scene/point_octree.h"
#include "render/scene/view_furniture.h"

namespace bole::render {
namespace {

PointCloud strewn(std::size_t points, const Eigen::Vector3d& origin) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> unit(0, 1);
  PointCloud::Positions p;
  for (std::size_t i = 0; i < points; ++i) p.emplace_back(20 * unit(random), 10 * unit(random), 5 * unit(random));
  PointCloud cloud(std::move(p), origin);
  cloud.scale = Eigen::Vector3d::Constant(0.001);
  cloud.set_column(arrays::intensity, std::vector<float>(points, 7));
  return cloud;
}

TEST(DrapedGround, FollowsTheTerrainAndGoesOnBesideIt) {
  Raster slope;
  slope.origin = {0, 0};
  slope.nx = slope.ny = 40;
  slope.cell_m = 0.5;
  for (int iy = 0; iy < 40; ++iy)
    for (int ix = 0; ix < 40; ++ix) slope.values.push_back(0.25F * (static_cast<float>(ix) + 0.5F) * 0.5F);
  slope.at(20, 20) = NAN;
  // Turned against the grid, and reaching 5 m beyond it.
  const GroundCorners corners{Eigen::Vector2d(-5, 25), {25, 25}, {25, -5}, {-5, -5}};
  const auto places = draped_ground(corners, slope, 7);
  ASSERT_EQ(places.at.size(), static_cast<std::size_t>(places.columns) * static_cast<std::size_t>(places.rows));
  EXPECT_EQ(places.columns, 61);  // of the cells of the terrain
  EXPECT_FALSE(places.behind_all);
  EXPECT_EQ(places.at.front().head<2>(), corners[0]);
  EXPECT_EQ(places.at.back().head<2>(), corners[2]);
  for (const auto& p : places.at) {
    const double within = std::clamp(p.x(), 0.25, 19.75);
    // A hole takes the height of its neighbours, which differ by 0.25 m; beyond the border nothing rises.
    EXPECT_NEAR(p.z(), 0.25 * within - 0.05, 0.2) << p.transpose();
  }
  Raster empty = slope;
  std::ranges::fill(empty.values, NAN);
  const auto flat = draped_ground(corners, empty, 7);
  EXPECT_TRUE(flat.behind_all);
  EXPECT_EQ(flat.at.size(), 4U);
  EXPECT_EQ(flat.at[2], Eigen::Vector3d(-5, -5, 7));
  // A picture of a wide place has no more places than can be drawn.
  const GroundCorners wide{Eigen::Vector2d(-900, 500), {900, 500}, {900, -500}, {-900, -500}};
  EXPECT_LE(draped_ground(wide, slope, 0).columns, 193);
}

TEST(PlacedCloud, ShiftsExactlyAndSharesItsPoints) {
  const auto cloud = strewn(1000, {563000, 5412000, 300});
  CloudPlace place;
  place.shift = {-563000, -5412000, 0.25};
  const auto moved = placed_cloud(cloud, place);
  EXPECT_EQ(moved.shared_positions(), cloud.shared_positions());
  EXPECT_EQ(moved.origin, Eigen::Vector3d(0, 0, 300.25));
  EXPECT_TRUE(moved.has(arrays::intensity));
  EXPECT_TRUE(moved.scale.isZero());
  EXPECT_EQ(placed_cloud(cloud, {}).scale, cloud.scale);
}

TEST(PlacedCloud, TurnsAboutItsPivotAndBack) {
  const Eigen::Vector3d origin(563000, 5412000, 300);
  const auto cloud = strewn(1000, origin);
  CloudPlace place;
  place.shift = {1, 2, 3};
  place.turn_rad = 0.7;
  place.pivot = {563010, 5412005, 302};
  const auto moved = placed_cloud(cloud, place);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d p = cloud.position(i), q = moved.position(i);
    ASSERT_LT((place.of(p) - q).norm(), 1e-5);
    ASSERT_NEAR((q - place.pivot - place.shift).head<2>().norm(), (p - place.pivot).head<2>().norm(), 1e-5);
    ASSERT_NEAR(q.z() - p.z(), 3, 1e-6);
    ASSERT_LT((place.back(q) - p).norm(), 1e-5);
  }
  // A quarter to the left takes east to north.
  place.shift.setZero();
  place.turn_rad = std::numbers::pi / 2;
  const Eigen::Vector3d east(place.pivot.x() + 4, place.pivot.y(), 0);
  EXPECT_LT((place.of(east) - Eigen::Vector3d(place.pivot.x(), place.pivot.y() + 4, 0)).norm(), 1e-9);
}

TEST(PlacedCloud, TiltsAndScalesAboutItsPivot) {
  const auto cloud = strewn(1000, {563000, 5412000, 300});
  CloudPlace place;
  place.shift = {1, 2, 3};
  place.turn_rad = 0.7;
  place.tilt_x_rad = 0.03;
  place.tilt_y_rad = -0.05;
  place.scale = 1.02;
  place.pivot = {563010, 5412005, 302};
  EXPECT_FALSE(place.only_shifts() || place.is_upright() || place.moves_nothing());
  EXPECT_LT((place.of(place.pivot) - place.pivot - place.shift).norm(), 1e-9);
  const auto moved = placed_cloud(cloud, place);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const Eigen::Vector3d p = cloud.position(i), q = moved.position(i);
    ASSERT_LT((place.of(p) - q).norm(), 1e-5);
    ASSERT_NEAR((q - place.pivot - place.shift).norm(), 1.02 * (p - place.pivot).norm(), 1e-5);
    ASSERT_LT((place.back(q) - p).norm(), 1e-5);
  }
  // Each angle by itself: about x what is north rises, about y what is up goes east.
  CloudPlace tilted;
  tilted.tilt_x_rad = std::numbers::pi / 2;
  EXPECT_LT((tilted.of({0, 1, 0}) - Eigen::Vector3d(0, 0, 1)).norm(), 1e-12);
  tilted.tilt_x_rad = 0;
  tilted.tilt_y_rad = std::numbers::pi / 2;
  EXPECT_LT((tilted.of({0, 0, 1}) - Eigen::Vector3d(1, 0, 0)).norm(), 1e-12);
}

// What a camera sees of moved nodes is what it sees of a cloud whose points were moved.
TEST(PlacedNodes, ChooseWhatTheMovedCloudHas) {
  const auto cloud = std::make_shared<const PointCloud>(strewn(60'000, {100, 200, 30}));
  const auto octree = std::make_shared<const PointOctree>(*cloud);
  CloudPlace place;
  place.shift = {5, -3, 1};
  place.turn_rad = 0.5;
  place.tilt_x_rad = 0.2;
  place.tilt_y_rad = -0.4;
  place.scale = 1.1;
  place.pivot = {110, 205, 32};
  const auto nodes = placed_nodes(nodes_in_memory(cloud, octree), place);
  const auto moved = placed_cloud(*cloud, place);
  EXPECT_LT((nodes->origin() - moved.origin).norm(), 1e-12);
  EXPECT_EQ(placed_nodes(nullptr, place), nullptr);

  // A box of the moved cloud: every point of it is among those of the nodes that are chosen.
  const Eigen::Vector3d centre = place.of({110, 205, 32});
  const Eigen::Vector3f middle = (centre - moved.origin).cast<float>(), half(2, 1, 2);
  OctreeView view;
  view.height_px = 1e6;
  view.world_to_clip(0, 0) = view.world_to_clip(1, 1) = view.world_to_clip(2, 2) = 0.01;
  view.lo = middle - half;
  view.hi = middle + half;
  std::size_t within = 0, expected = 0, all = 0;
  const auto holds = [&](const Eigen::Vector3d& p) {
    return ((p - centre).cast<float>().cwiseAbs().array() <= half.array()).all();
  };
  for (const auto node : nodes->choose(view, 1'000'000, 1e-9)) {
    const auto set = nodes->points(node);
    all += set.indices.size();
    for (const auto i : set.indices) within += holds(set.cloud->position(i));
  }
  for (std::size_t i = 0; i < moved.size(); ++i) expected += holds(moved.position(i));
  EXPECT_GT(expected, 100u);
  EXPECT_EQ(within, expected);
  EXPECT_LT(all, cloud->size());
}

TEST(GroundBelow, IsThatOfTheSurvey) {
  PointCloud::Positions p;
  std::vector<float> heights;
  for (int x = 0; x < 100; ++x)
    for (int y = 0; y < 100; ++y) {
      const float ground = 0.02f * static_cast<float>(x), above = static_cast<float>((x * 7 + y * 3) % 20);
      p.emplace_back(0.2f * static_cast<float>(x), 0.2f * static_cast<float>(y), ground + above);
      heights.push_back(above);
    }
  PointCloud cloud(std::move(p), {500, 600, 70});
  EXPECT_TRUE(GroundBelow(cloud).empty());
  cloud.set_column(arrays::height_above_ground, heights);
  const GroundBelow ground(cloud);
  EXPECT_NEAR(ground.z_at({510, 610}), 71, 0.06);
  EXPECT_NEAR(ground.z_at({500.1, 600.1}), 70, 0.06);
  EXPECT_TRUE(std::isfinite(ground.z_at({521.5, 610})));
  EXPECT_TRUE(std::isnan(ground.z_at({540, 610})));
  const auto heights_of_cells = ground.heights();
  EXPECT_EQ(heights_of_cells.nx, 20);
  EXPECT_EQ(heights_of_cells.ny, 20);
  EXPECT_NEAR(heights_of_cells.sample(510, 610), 71, 0.06);
  EXPECT_EQ(GroundBelow(PointCloud()).heights().nx, 0);
}

TEST(GroundBelow, HeightsOfCellsBelowZeroLieWhereTheyAre) {
  PointCloud cloud({{-7.5, -3.5, 1}, {2.5, 4.5, 5}, {2.6F, 4.4F, 7}});
  cloud.set_column(arrays::height_above_ground, std::vector<float>{0, 0, 1});
  const auto heights = GroundBelow(cloud).heights();
  EXPECT_EQ(heights.origin, Eigen::Vector2d(-8, -4));
  ASSERT_EQ(heights.nx, 11);
  ASSERT_EQ(heights.ny, 9);
  EXPECT_FLOAT_EQ(heights.at(0, 0), 1);
  EXPECT_FLOAT_EQ(heights.at(10, 8), 5.5F);
  EXPECT_TRUE(std::isnan(heights.at(5, 4)));
}

TEST(CloudKeys, StandInTheViewOnlyWhereThereAreClouds) {
  ViewFurniture f;
  f.width_mm = 200;
  f.height_mm = 150;
  const auto before = furniture_patches(f).size();
  f.clouds = {{"last_year.laz", hex(0xd55e00)}, {"ein sehr langer Name einer sehr großen Wolke im Wald.laz", {}}};
  const auto patches = furniture_patches(f);
  ASSERT_EQ(patches.size(), before + 1);
  const auto image = figure_image(patches.back().figure, 96);
  int orange = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const auto c = image.pixel(x, y);
      orange += c.r > 0.8 && c.g > 0.3 && c.g < 0.45 && c.b < 0.1;
    }
  EXPECT_GT(orange, 20);
  EXPECT_LE(patches.back().box.x1, f.width_mm);
  EXPECT_GE(patches.back().box.x0, 0);
}

// The legend of a cloud stands beside that of the survey, and in its place where that has none.
TEST(CloudLegend, StandsLeftOfThatOfTheSurvey) {
  ViewFurniture f;
  f.width_mm = 200;
  f.height_mm = 150;
  f.north = false;
  PointPaint paint;
  paint.kind = PointPaint::Kind::map;
  paint.map = &ColorMap::viridis();
  paint.range = {0, 0.4};
  paint.title = "distance (m)";
  f.clouds_paint = paint;
  const auto alone = furniture_patches(f);
  ASSERT_EQ(alone.size(), 1u);
  f.paint = paint;
  f.paint->title = "z (m)";
  const auto both = furniture_patches(f);
  ASSERT_EQ(both.size(), 2u);
  EXPECT_NEAR(both[0].box.x0, alone[0].box.x0, 1e-9);
  EXPECT_LE(both[1].box.x1, both[0].box.x0);
  EXPECT_GE(both[1].box.x0, 0);
}

int pixels_of(const Figure& figure, const Color& color) {
  const auto image = figure_image(figure, 150);
  int count = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const auto c = image.pixel(x, y);
      count += std::abs(c.r - color.r) + std::abs(c.g - color.g) + std::abs(c.b - color.b) <
               0.5;  // what shines through is paler
    }
  return count;
}

TEST(CloudDots, StandInSliceAndProfileInTheirColour) {
  const Color orange = hex(0xd55e00);
  CloudDots dots{{"last_year.laz", orange}, {}};
  StemSliceData slice;
  StemProfileData profile;
  slice.points = {{0.05, 0.05}};
  profile.points = {{0.1, 1}};
  EXPECT_EQ(pixels_of(stem_slice(slice, 80, 80), orange), 0);
  EXPECT_EQ(pixels_of(stem_profile(profile, 60, 80), orange), 0);
  for (int i = 0; i < 60; ++i) dots.points.emplace_back(-0.1 - 0.002 * i, -0.1);
  slice.beside = {dots};
  const int key_only = [&] {
    auto empty = slice;
    empty.beside.front().points.clear();
    return pixels_of(stem_slice(empty, 80, 80), orange);
  }();
  EXPECT_GT(key_only, 10);
  EXPECT_GT(pixels_of(stem_slice(slice, 80, 80), orange), key_only + 50);
  for (auto& p : dots.points) p.y() = 4;
  profile.beside = {dots};
  EXPECT_GT(pixels_of(stem_profile(profile, 60, 80), orange), 50);
}

}  // namespace
}  // namespace bole::render
