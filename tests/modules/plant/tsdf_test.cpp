#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "plant/core/surface/surface_points.h"
#include "synthetic/plant_scene.h"

namespace bole::plant {
namespace {

using synthetic::PlantSceneViews;

double quantile(std::vector<double> values, double share) {
  std::ranges::sort(values);
  return values.at(static_cast<std::size_t>(share * static_cast<double>(values.size() - 1)));
}

std::vector<double> errors_of(const PointCloud& cloud, const synthetic::PlantScene& scene) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < cloud.size(); ++i) errors.push_back(scene.distance(cloud.position(i)));
  return errors;
}

FuseOptions small_fusion() {
  FuseOptions o;
  o.voxel = 0.002;
  return o;
}

struct Fused {
  Region region;
  Tsdf grid;
  Report report;
};

Fused fuse(const PlantSceneViews& views, const FuseOptions& options) {
  Fused f;
  const auto posed = posed_views(views, views.given_poses(), 1, f.report);
  f.region = find_region(views, posed, options.min_share, bole::Run{}, f.report);
  f.grid = fuse_depth(views, posed, f.region, options, bole::Run{}, f.report);
  return f;
}

TEST(Tsdf, SurfaceLiesOnTheScene) {
  for (const bool own_depth_camera : {false, true}) {
    PlantSceneViews::Settings settings;
    settings.own_depth_camera = own_depth_camera;
    const PlantSceneViews views(settings);
    const auto f = fuse(views, small_fusion());
    const auto cloud = surface_points(f.grid, 2);
    ASSERT_GT(cloud.size(), 5000U);
    const auto errors = errors_of(cloud, views.scene());
    EXPECT_LT(quantile(errors, 0.5), 0.0004);
    EXPECT_LT(quantile(errors, 0.95), 0.003);
  }
}

TEST(Tsdf, NoisyDepthIsAveraged) {
  PlantSceneViews::Settings settings;
  settings.depth_noise = 0.0015;
  const PlantSceneViews views(settings);
  const auto f = fuse(views, small_fusion());
  EXPECT_LT(quantile(errors_of(surface_points(f.grid, 2), views.scene()), 0.5), 0.0009);
}

TEST(Tsdf, TheRegionHoldsThePlantAndNotTheWholeTable) {
  const PlantSceneViews views({});
  const auto f = fuse(views, small_fusion());
  for (const auto& leaf : views.scene().leaves) {
    EXPECT_TRUE(f.region.contains(leaf.centre + leaf.radii));
    EXPECT_TRUE(f.region.contains(leaf.centre - leaf.radii));
  }
  EXPECT_LT(f.region.size().maxCoeff(), 0.75);
  EXPECT_LT(f.region.min.z(), 0);
}

TEST(Tsdf, NormalsPointToTheCamerasAndColoursAreThoseOfTheScene) {
  const PlantSceneViews views({});
  const auto f = fuse(views, small_fusion());
  const auto cloud = surface_points(f.grid, 2);
  const auto& nz = cloud.values<float>("normal_z");
  const auto& red = cloud.values<std::uint16_t>(arrays::red);
  const auto& green = cloud.values<std::uint16_t>(arrays::green);
  int table = 0, up = 0, leaf = 0, is_green = 0;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const auto p = cloud.position(i);
    if (std::abs(p.z()) < 0.002 && p.head<2>().norm() > 0.06) {
      ++table;
      up += nz[i] > 0.9F;
    }
    if (p.z() > 0.12 && p.head<2>().norm() > 0.015) {
      ++leaf;
      is_green += green[i] > red[i];
    }
  }
  ASSERT_GT(table, 1000);
  EXPECT_GT(up, 0.98 * table);
  ASSERT_GT(leaf, 300);
  EXPECT_GT(is_green, 0.95 * leaf);
}

TEST(Tsdf, TheMeshHasTheSurfaceOfThePoints) {
  const PlantSceneViews views({});
  const auto f = fuse(views, small_fusion());
  const auto mesh = surface_mesh(f.grid, 2);
  ASSERT_GT(mesh.triangles.rows(), 5000U);
  EXPECT_LT(quantile(errors_of(mesh.vertices, views.scene()), 0.5), 0.0006);
  const auto a = mesh.triangles.integers("a"), b = mesh.triangles.integers("b"), c = mesh.triangles.integers("c");
  const auto& nz = mesh.vertices.values<float>("normal_z");
  int along = 0, against = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto at = [&](std::int64_t v) { return mesh.vertices.position(static_cast<std::size_t>(v)); };
    const Eigen::Vector3d normal = (at(b[i]) - at(a[i])).cross(at(c[i]) - at(a[i]));
    if (normal.norm() < 1e-9 || std::abs(nz[static_cast<std::size_t>(a[i])]) < 0.5F) continue;
    (normal.z() * nz[static_cast<std::size_t>(a[i])] > 0 ? along : against) += 1;
  }
  EXPECT_GT(along, 50 * against);
}

TEST(Tsdf, ClearErrors) {
  Report report;
  PlantSceneViews::Settings settings;
  const PlantSceneViews views(settings);
  EXPECT_THROW(posed_views(views, Trajectory{}, 1, report), Error);
  settings.depth = false;
  const PlantSceneViews blind(settings);
  const auto posed = posed_views(blind, blind.given_poses(), 1, report);
  EXPECT_THROW(fuse_depth(blind, posed, {}, {}, bole::Run{}, report), Error);
  EXPECT_THROW(region_from_text("1 2 3"), Error);
  EXPECT_THROW(region_from_text("0 0 0 1 1 -1"), Error);
  EXPECT_THROW(region_from_text("a b c d e f"), Error);
  EXPECT_FALSE(region_from_text("  "));
  EXPECT_TRUE(region_from_text("0,0,0 1 1 1"));
}

TEST(Tsdf, TooLittleMemoryEnlargesTheVoxelsAndSaysSo) {
  const PlantSceneViews views({});
  auto options = small_fusion();
  options.max_memory_mib = 16;
  options.voxel = 0.001;
  const auto f = fuse(views, options);
  EXPECT_GT(f.grid.voxel, 0.001);
  ASSERT_FALSE(f.report.findings.empty());
  EXPECT_EQ(f.report.findings.back().code, "voxel_enlarged");
}

// The table of the scene is 0.8 m wide; the plant is 0.12 m wide and 0.17 m high.
TEST(Region, WhatStandsOnATableLeavesTheTableOut) {
  PlantSceneViews::Settings settings;
  settings.depth_noise = 0.002;
  const PlantSceneViews views(settings);
  Report report;
  const auto posed = posed_views(views, views.given_poses(), 3, report);
  const auto all = find_region(views, posed, 0.6, bole::Run{}, report);
  const auto standing = find_standing_region(views, posed, 0.6, bole::Run{}, report);
  EXPECT_EQ(report.facts.at("region_from"), "what stands on a plane");
  EXPECT_GT(all.size().head<2>().maxCoeff(), 0.3);
  EXPECT_LT(standing.size().head<2>().maxCoeff(), 0.2);
  for (const Eigen::Vector3d& p : {Eigen::Vector3d(0.06, 0, 0.16), {-0.055, 0, 0.13}, {0, -0.06, 0.14}, {0.04, 0, 0}})
    EXPECT_TRUE(standing.contains(p)) << p.transpose();
}

TEST(Region, AnEmptyTableIsKeptWhole) {
  // Without the plant nothing stands on the table: the whole of it is kept.
  PlantSceneViews::Settings settings;
  const PlantSceneViews views(settings, {.leaves = {}, .cylinders = {}});
  Report report;
  const auto posed = posed_views(views, views.given_poses(), 3, report);
  const auto all = find_region(views, posed, 0.6, bole::Run{}, report);
  const auto standing = find_standing_region(views, posed, 0.6, bole::Run{}, report);
  EXPECT_EQ(report.facts.at("region_from"), "depth in the common view");
  EXPECT_EQ(all.min, standing.min);
  EXPECT_EQ(all.max, standing.max);
}

}  // namespace
}  // namespace bole::plant
