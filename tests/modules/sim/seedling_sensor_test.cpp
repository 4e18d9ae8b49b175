#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/angles.h"
#include "sim/core/camera/depth_sensor.h"
#include "sim/core/seedling/plant_motion.h"
#include "sim/core/seedling/seedling_scene.h"

namespace bole::sim {
namespace {

// A sheet facing the camera, which stands in the origin and looks along z: x and y from `low` to `high` at depth z.
ScenePart sheet(const Eigen::Vector2d& low, const Eigen::Vector2d& high, double z) {
  ScenePart part;
  part.surface = PartSurface::table;
  for (const double y : {low.y(), high.y()})
    for (const double x : {low.x(), high.x()}) part.add({x, y, z}, {x, y});
  part.triangles = {{0, 2, 1}, {1, 2, 3}};
  part.set_normals();
  part.light.assign(4, 1.0F);
  part.through.assign(4, 0.0F);
  return part;
}

PictureScene scene_of(std::vector<ScenePart> world) {
  PictureScene scene;
  scene.world = std::move(world);
  scene.room = {sheet({-5, -5}, {5, 5}, 3)};
  scene.world_rays.emplace(scene.world);
  scene.room_rays.emplace(scene.room);
  return scene;
}

CameraModel plain_camera(int width, int height, double focal) {
  CameraModel c;
  c.width = width;
  c.height = height;
  c.fx = c.fy = focal;
  c.cx = 0.5 * (width - 1);
  c.cy = 0.5 * (height - 1);
  return c;
}

struct Spread {
  double mean = 0, sd = 0, share = 0;
};

// Of the depths in the middle of a picture.
Spread spread_of(const DepthImage& depth, int margin) {
  double sum = 0, squares = 0;
  int count = 0, all = 0;
  for (int y = margin; y < depth.height - margin; ++y)
    for (int x = margin; x < depth.width - margin; ++x, ++all) {
      const double z = static_cast<double>(depth.at(x, y));
      if (z <= 0) continue;
      sum += z;
      squares += z * z;
      ++count;
    }
  const double mean = sum / count;
  return {mean, std::sqrt(std::max(0.0, squares / count - mean * mean)), static_cast<double>(count) / all};
}

TEST(SeedlingSensors, TheKinectHasThePublishedNoise) {
  const auto scene = scene_of({sheet({-2, -2}, {2, 2}, 1)});
  const PixelDirections pixels(plain_camera(300, 200, 585));
  const auto depth = kinect_depth(scene, pixels, {}, 1, 7);
  const auto spread = spread_of(depth, 10);
  const double step = 0.125 / (585 * 0.075);  // one step of disparity at 1 m
  const double axial = 0.0012 + 0.0019 * 0.36;
  EXPECT_NEAR(spread.mean, 1, 2e-4);
  EXPECT_NEAR(spread.sd, std::sqrt(axial * axial + step * step / 12), 1e-4);
  EXPECT_GT(spread.share, 0.999);
  EXPECT_NEAR(spread_of(kinect_depth(scene, pixels, {}, 0, 7), 10).sd, 0, 1e-6);
}

TEST(SeedlingSensors, TheProjectorOfTheKinectLeavesAShadow) {
  const auto scene = scene_of({sheet({-2, -2}, {2, 2}, 1), sheet({-0.05, -0.5}, {0.05, 0.5}, 0.6)});
  const auto camera = plain_camera(640, 100, 585);
  const auto depth = kinect_depth(scene, PixelDirections(camera), {}, 0, 7);
  // The projector stands 75 mm to the left: the shadow lies to the right of the bar, 73 pixels * (1 / 0.6 - 1 / 1)
  // wide.
  int holes_left = 0, holes_right = 0;
  for (int x = 0; x < camera.width; ++x) (x < 320 ? holes_left : holes_right) += depth.at(x, 50) == 0 ? 1 : 0;
  EXPECT_EQ(holes_left, 0);
  EXPECT_NEAR(holes_right, 585 * 0.075 * (1 / 0.6 - 1), 3);
}

DepthImage stereo_of(const PictureScene& scene, const CameraModel& camera) {
  const PixelDirections pixels(camera);
  return match_infrared(render_infrared(scene, Lighting(1), SurfaceColors(1), pixels, {}, 1, 3), camera);
}

TEST(SeedlingSensors, TheStereoPairMeasuresAPlane) {
  const auto camera = plain_camera(640, 240, 385);
  const auto depth = stereo_of(scene_of({sheet({-2, -2}, {2, 2}, 0.72)}), camera);
  std::vector<double> errors;
  for (int y = 20; y < 220; ++y)
    for (int x = 120; x < 600; ++x)
      if (depth.at(x, y) > 0) errors.push_back(std::abs(static_cast<double>(depth.at(x, y)) - 0.72));
  ASSERT_GT(static_cast<double>(errors.size()), 0.95 * 200 * 480);
  std::ranges::nth_element(errors, errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2));
  // The matcher draws disparities towards whole pixels, by up to 0.15 pixels.
  EXPECT_LT(errors[errors.size() / 2], 0.15 * 0.72 * 0.72 / (385 * stereo_baseline));
}

TEST(SeedlingSensors, TheStereoPairThickensAStemOf5Millimetres) {
  const auto camera = plain_camera(640, 240, 385);
  const auto depth =
      stereo_of(scene_of({sheet({-5, -5}, {5, 5}, 2), sheet({-0.0025, -0.15}, {0.0025, 0.15}, 0.5)}), camera);
  double near = 0;
  int rows = 0;
  for (int y = 40; y < 200; ++y, ++rows)
    for (int x = 280; x < 360; ++x) near += depth.at(x, y) > 0 && depth.at(x, y) < 0.6F ? 1 : 0;
  const double width = near / rows * 0.5 / 385;
  EXPECT_GT(width, 0.007);
  EXPECT_LT(width, 0.025);
}

TEST(SeedlingSensors, TimeOfFlightMixesDepthsAtEdges) {
  const auto scene = scene_of({sheet({-2, -2}, {2, 2}, 0.8), sheet({-2, -2}, {0.0003, 2}, 0.5)});
  const auto camera = plain_camera(160, 90, 300);
  const auto depth = tof_depth(scene, SurfaceColors(1), PixelDirections(camera), {}, 0, 5);
  int between = 0;
  for (int y = 5; y < 85; ++y) {
    EXPECT_NEAR(depth.at(40, y), 0.5, 1e-4);
    EXPECT_NEAR(depth.at(120, y), 0.8, 2e-4);
    for (int x = 70; x < 90; ++x) between += depth.at(x, y) > 0.52F && depth.at(x, y) < 0.78F ? 1 : 0;
  }
  EXPECT_GT(between, 60);  // one pixel in a row
  EXPECT_LT(between, 170);
  const auto noisy =
      tof_depth(scene_of({sheet({-2, -2}, {2, 2}, 0.8)}), SurfaceColors(1), PixelDirections(camera), {}, 1, 5);
  const auto spread = spread_of(noisy, 5);
  EXPECT_NEAR(spread.mean, 0.8, 3e-4);
  EXPECT_GT(spread.sd, 0.0005);
  EXPECT_LT(spread.sd, 0.004);
}

TEST(SeedlingSensors, RegisteredDepthIsThatOfTheColourCamera) {
  RgbdCamera camera;
  camera.color = plain_camera(320, 180, 230);
  camera.depth = plain_camera(200, 150, 130);
  camera.T_color_depth.translation() << -0.02, 0.001, 0.002;
  camera.T_color_depth.linear() = Eigen::AngleAxisd(0.01, Eigen::Vector3d::UnitY()).toRotationMatrix();
  const auto scene = scene_of({sheet({-2, -2}, {2, 2}, 0.9), sheet({-0.1, -0.1}, {0.1, 0.1}, 0.6)});
  const ViewPose view;
  const auto seen = render_depth(scene, PixelDirections(*camera.depth), view.mounted(camera.T_color_depth));
  const auto registered = register_to_color(seen.depth, camera);
  const auto exact = render_depth(scene, PixelDirections(camera.color), view);
  int agree = 0, all = 0;
  for (int y = 20; y < 160; ++y)
    for (int x = 40; x < 280; ++x, ++all)
      agree += std::abs(registered.at(x, y) - exact.depth.at(x, y)) < 0.004F ? 1 : 0;
  EXPECT_GT(agree, 0.95 * all);  // but for the border of the nearer sheet and its shadow
}

TEST(SeedlingSensors, DistortedPixelsLookWhereTheModelSays) {
  SeedlingSimulationOptions o;
  o.distortion = 1;
  o.width = 640;
  const auto camera = draw_camera(o).color;
  camera.check();
  const PixelDirections pixels(camera);
  double off = 0, bent = 0;
  for (int y = 0; y < camera.height; y += 7)
    for (int x = 0; x < camera.width; x += 7) {
      const Eigen::Vector2d at(x + 0.3, y - 0.2);
      const auto back = camera.project(pixels.at(at.x(), at.y()));
      ASSERT_TRUE(back);
      off = std::max(off, (*back - at).norm());
      const Eigen::Vector3d straight((x - camera.cx) / camera.fx, (y - camera.cy) / camera.fy, 1);
      bent = std::max(bent, camera.fx * (straight - pixels.at(x, y)).norm());
    }
  EXPECT_LT(off, 1e-3);
  EXPECT_GT(bent, 2);
}

TEST(SeedlingSensors, AMovingCameraSmearsThePicture) {
  const auto scene = scene_of({sheet({-2, -2}, {2, 2}, 1)});
  const PixelDirections pixels(plain_camera(160, 100, 300));
  const Lighting lighting(1);
  const SurfaceColors colors(1);
  const auto roughness = [&](const ViewPose& view) {
    PictureOptions o;
    o.samples = 3;
    const auto light = render_picture(scene, lighting, colors, pixels, view, o, 1);
    double sum = 0;
    for (int y = 10; y < 89; ++y)
      for (int x = 10; x < 150; ++x) sum += std::abs(static_cast<double>(light.at(x, y + 1, 1) - light.at(x, y, 1)));
    return sum;
  };
  ViewPose still, moved;
  moved.world_motion[4] = 0.03;  // 9 pixels across the grain of the wood during the exposure
  EXPECT_LT(roughness(moved), 0.7 * roughness(still));
}

SeedlingSimulationOptions scene_options(SeedlingRoute route) {
  SeedlingSimulationOptions o;
  o.seed = 4;
  o.width = 160;
  o.views = 60;
  o.route = route;
  return o;
}

TEST(SeedlingRoutes, CamerasLookAtThePlantFromAllSides) {
  for (const auto route : {SeedlingRoute::orbit, SeedlingRoute::turntable, SeedlingRoute::handheld}) {
    const auto scene = build_seedling_scene(scene_options(route));
    ASSERT_EQ(scene.route.size(), 60U);
    const Eigen::Vector3d plant = scene.plant.foot + Eigen::Vector3d(0, 0, 0.1);
    std::array<int, 8> sectors{};
    double low = 1e9, high = -1e9;
    for (const auto& view : scene.route) {
      const Eigen::Vector3d from = view.pose.T_world_camera.translation() - plant;
      const double distance = from.head<2>().norm();
      EXPECT_GT(from.norm(), 0.3);
      EXPECT_LT(from.norm(), 0.85);
      EXPECT_LT(distance, 0.85);
      const double angle = std::atan2(from.y(), from.x()) + std::numbers::pi;
      ++sectors[static_cast<std::size_t>(std::min(7.0, angle / (std::numbers::pi / 4)))];
      low = std::min(low, from.z());
      high = std::max(high, from.z());
      const Eigen::Vector3d in_camera = view.pose.T_world_camera.inverse() * plant;
      const auto pixel = scene.camera.color.project(in_camera);
      ASSERT_TRUE(pixel);
      EXPECT_TRUE(scene.camera.color.contains(*pixel));
      EXPECT_NEAR(view.pose.T_world_camera.linear().determinant(), 1, 1e-9);
    }
    for (const int count : sectors) EXPECT_GE(count, 3);
    if (route != SeedlingRoute::turntable) {
      EXPECT_GT(high - low, 0.1);
    }
  }
}

TEST(SeedlingRoutes, TopAndFootOfATallPlantAreInManyViews) {
  auto o = scene_options(SeedlingRoute::orbit);
  o.plant = "citrus_tall";
  const auto scene = build_seedling_scene(o);
  Eigen::Vector3d top = scene.plant.foot;
  for (const auto& part : scene.picture.world)
    for (const auto& p : part.positions)
      if (static_cast<double>(p.z()) > top.z()) top = p.cast<double>();
  ASSERT_GT(top.z() - scene.plant.foot.z(), 0.4);
  int tops = 0, feet = 0;
  for (const auto& view : scene.route) {
    const auto in_view = [&](const Eigen::Vector3d& at) {
      const auto pixel = scene.camera.color.project(view.pose.T_world_camera.inverse() * at);
      return pixel && scene.camera.color.contains(*pixel);
    };
    tops += in_view(top) ? 1 : 0;
    feet += in_view(scene.plant.foot) ? 1 : 0;
  }
  EXPECT_GE(tops, 20);  // of 60
  EXPECT_GE(feet, 20);
}

TEST(SeedlingRoutes, BehindATurntableTheRoomStandsStill) {
  auto scene = build_seedling_scene(scene_options(SeedlingRoute::turntable));
  const PixelDirections pixels(scene.camera.color);
  std::vector<DepthImage> depths;
  for (const std::size_t i : {0U, 20U}) {
    scene.picture.T_room_world = scene.route[i].T_room_world;
    EXPECT_TRUE((scene.route[i].T_room_world * scene.route[i].pose.T_world_camera)
                    .isApprox(scene.route[0].pose.T_room_camera, 1e-9));
    depths.push_back(render_depth(scene.picture, pixels, scene.route[i].pose).depth);
  }
  int background = 0, changed = 0;
  for (std::size_t i = 0; i < depths[0].values.size(); ++i) {
    changed += std::abs(depths[0].values[i] - depths[1].values[i]) > 1e-4F ? 1 : 0;
    if (depths[0].values[i] < 1.2F || depths[1].values[i] < 1.2F) continue;
    ++background;
    EXPECT_NEAR(depths[0].values[i], depths[1].values[i], 1e-4);
  }
  EXPECT_GT(background, 2000);
  EXPECT_GT(changed, 200);  // the plant turned
}

TEST(SeedlingRoutes, LeavesSwingAboutTheirFeet) {
  auto scene = build_seedling_scene(scene_options(SeedlingRoute::orbit));
  const auto rest = scene.picture.world;
  const double swing = 5 * rad_per_deg;
  const PlantSway sway(rest, scene.plant, swing, 1);
  double largest = 0;
  for (const double view : {1.0, 4.0, 7.0}) {
    sway.move(scene.picture.world, view);
    for (std::size_t p = 0; p < rest.size(); ++p)
      for (std::size_t k = 0; k < rest[p].positions.size(); ++k) {
        const double moved = static_cast<double>((scene.picture.world[p].positions[k] - rest[p].positions[k]).norm());
        if (rest[p].label != PartLabel::plant) {
          ASSERT_EQ(moved, 0);
        } else if (static_cast<double>(rest[p].positions[k].z()) < scene.plant.foot.z()) {
          ASSERT_LT(moved, 1e-6);
        }
        largest = std::max(largest, moved);
      }
  }
  EXPECT_GT(largest, 0.002);
  EXPECT_LT(largest, swing * 0.12 + 0.1 * swing * 0.4);
  PlantSway(rest, scene.plant, 0, 1).move(scene.picture.world, 3);
  for (std::size_t p = 0; p < rest.size(); ++p)
    for (std::size_t k = 0; k < rest[p].positions.size(); ++k)
      ASSERT_LT((scene.picture.world[p].positions[k] - rest[p].positions[k]).norm(), 1e-6F);
}

}  // namespace
}  // namespace bole::sim
