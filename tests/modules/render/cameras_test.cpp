// Cameras of a scene and what they see of a cloud.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "base/error.h"
#include "render/scene/camera_shapes.h"
#include "render/scene/seen_points.h"

namespace bole::render {
namespace {

CameraModel camera() { return {.width = 160, .height = 120, .fx = 150, .fy = 150, .cx = 79.5, .cy = 59.5}; }

// A wall at z = `z` with points every millimetre.
void add_wall(PointCloud::Positions& positions, float z, float half, float x0 = 0) {
  for (float x = -half; x <= half; x += 0.001F)
    for (float y = -half; y <= half; y += 0.001F) positions.emplace_back(x0 + x, y, z);
}

TEST(CameraShapes, CornersAreThoseOfThePicture) {
  const CameraShape shape{.view = 3, .camera = camera()};
  const auto corners = picture_corners(shape, 2);
  ASSERT_EQ(corners.size(), 4U);
  EXPECT_TRUE(corners[0].isApprox(Eigen::Vector3d(-80.0 / 150 * 2, -60.0 / 150 * 2, 2)));
  EXPECT_TRUE(corners[2].isApprox(Eigen::Vector3d(80.0 / 150 * 2, 60.0 / 150 * 2, 2)));
  // The roof stands over the upper edge: towards negative y of the camera.
  double top = 0;
  for (const auto& [a, b] : camera_edges(shape, 2)) top = std::min({top, a.y(), b.y()});
  EXPECT_LT(top, corners[0].y());
}

TEST(CameraShapes, DepthFollowsTheStepsAndTheScene) {
  std::vector<CameraShape> shapes;
  for (int i = 0; i < 20; ++i) {
    shapes.push_back({.view = static_cast<std::size_t>(i), .camera = camera()});
    shapes.back().T_world_camera.translation().x() = 0.03 * i;
  }
  EXPECT_NEAR(camera_depth_m(shapes, 1), 0.03, 1e-9);
  EXPECT_NEAR(camera_depth_m(shapes, 0.1), 0.01, 1e-9);
  EXPECT_NEAR(camera_depth_m(shapes, 10), 0.2, 1e-9);
  EXPECT_GT(camera_depth_m({shapes[0]}, 0), 0);
}

TEST(CameraShapes, AreFoundUnderTheMouse) {
  // A parallel view down the z axis, 200 px for 2 m.
  PickView view;
  view.width_px = view.height_px = 200;
  std::vector<CameraShape> shapes{{.view = 7, .camera = camera()}, {.view = 8, .camera = camera()}};
  shapes[1].T_world_camera.translation().x() = 0.5;
  EXPECT_EQ(pick_camera(view, shapes, 0.1, {150, 100}, 3)->view, 8U);
  EXPECT_EQ(pick_camera(view, shapes, 0.1, {101, 100}, 3)->view, 7U);
  EXPECT_FALSE(pick_camera(view, shapes, 0.1, {20, 20}, 3));
}

TEST(SeenPoints, SpacingIsThatOfTheNeighbours) {
  PointCloud::Positions positions;
  add_wall(positions, 1, 0.03F);
  EXPECT_NEAR(point_spacing_m(PointCloud(positions)), 0.001, 1e-5);
  EXPECT_EQ(point_spacing_m(PointCloud()), 0);
  EXPECT_EQ(point_spacing_m(PointCloud(PointCloud::Positions(3, Eigen::Vector3f::Ones()))), 0);
}

TEST(SeenPoints, WhatIsInFrontHidesWhatIsBehind) {
  PointCloud::Positions positions;
  add_wall(positions, 0.5F, 0.05F);
  const std::size_t front = positions.size();
  add_wall(positions, 0.8F, 0.2F);
  // The cloud has an origin far away, as projected coordinates have.
  const Eigen::Vector3d origin(4e5, 5e6, 100);
  const PointCloud cloud(positions, origin);
  Pose T_world_camera = Pose::Identity();
  T_world_camera.translation() = origin;
  const auto seen = see_cloud(cloud, camera(), T_world_camera, 0.001);
  std::size_t in_front = 0, hidden = 0;
  for (const auto& p : seen.points) {
    if (p.index < front) {
      ++in_front;
      EXPECT_NEAR(p.depth_m, 0.5, 1e-6);
    } else {
      // The shadow of the front wall on the wall behind reaches 0.08 m to each side.
      const auto& q = positions[p.index];
      hidden += std::abs(q.x()) < 0.075F && std::abs(q.y()) < 0.075F;
    }
  }
  EXPECT_EQ(in_front, front);
  EXPECT_EQ(hidden, 0U);
  EXPECT_GT(seen.points.size(), front + 10000);
  EXPECT_FLOAT_EQ(seen.depth.at(80, 60), 0.5F);
  EXPECT_FLOAT_EQ(seen.depth.at(110, 60), 0.8F);
}

TEST(SeenPoints, ResidualIsMeasuredMinusCloud) {
  DepthImage measured(2, 2), of_cloud(2, 2);
  measured.values = {1, 0, 2, 3};
  of_cloud.values = {0.75F, 1, 0, 3.5F};
  const auto residual = depth_residual(measured, of_cloud);
  EXPECT_FLOAT_EQ(residual.values[0], 0.25F);
  EXPECT_TRUE(std::isnan(residual.values[1]));
  EXPECT_TRUE(std::isnan(residual.values[2]));
  EXPECT_FLOAT_EQ(residual.values[3], -0.5F);
  EXPECT_THROW(depth_residual(measured, DepthImage(3, 2)), Error);
}

}  // namespace
}  // namespace bole::render
