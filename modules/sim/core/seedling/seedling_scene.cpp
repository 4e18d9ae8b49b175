#include "sim/core/seedling/seedling_scene.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/core/scene/random.h"
#include "sim/core/seedling/plant_mesh.h"

namespace bole::sim {
namespace {

double top_of(const std::vector<ScenePart>& parts) {
  double top = 0;
  for (const auto& part : parts)
    for (const auto& p : part.positions) top = std::max(top, static_cast<double>(p.z()));
  return top;
}

}  // namespace

RgbdCamera draw_camera(const SeedlingSimulationOptions& o) {
  Random random(static_cast<std::uint64_t>(o.seed), Stream::picture, 1);
  const auto drawn = [&random](int width, int height, double focal, double spread) {
    CameraModel c;
    c.width = width;
    c.height = height;
    c.fx = focal * (1 + 0.0065 * random.bounded_normal());
    c.fy = c.fx * (1 + 0.0005 * random.bounded_normal());
    c.cx = 0.5 * (width - 1) + spread * random.bounded_normal();
    c.cy = 0.5 * (height - 1) + spread * random.bounded_normal();
    return c;
  };
  RgbdCamera camera;
  camera.depth_scale = o.depth_scale;
  camera.color = drawn(1280, 720, 920, 5).scaled(o.width / 1280.0);
  const std::array<double, 5> webcam{0.08, -0.16, 0.0006, -0.0004, 0.05};
  for (std::size_t i = 0; i < webcam.size(); ++i)
    camera.color.distortion[i] = o.distortion * webcam[i] * (1 + 0.2 * random.bounded_normal());
  if (o.sensor != SeedlingSensor::stereo && o.sensor != SeedlingSensor::tof) return camera;
  camera.depth = drawn(640, 400, 385, 3).scaled(o.depth_width / 640.0);
  const bool pair = o.sensor == SeedlingSensor::stereo;
  if (pair) camera.depth->fy = camera.depth->fx;  // rectified
  Vector6d mount;
  for (int k = 0; k < 3; ++k) mount[k] = 0.004 * random.bounded_normal();
  mount.tail<3>() << (pair ? -0.015 : -0.032), 0.0005 * random.bounded_normal(), 0.001 * random.bounded_normal();
  camera.T_color_depth = se3_exp(mount);
  return camera;
}

SeedlingScene build_seedling_scene(const SeedlingSimulationOptions& o) {
  const auto seed = static_cast<std::uint64_t>(o.seed);
  const auto recipe = read_seedling(o.plant);
  const Pot pot = draw_pot(recipe.pot, seed);
  SeedlingScene s{
      recipe,         pot, grow_seedling(recipe, seed, pot.soil_middle()), {}, Lighting(seed), SurfaceColors(seed),
      draw_camera(o), {}};
  auto& world = s.picture.world;
  world = plant_parts(s.plant);
  world.push_back(pot_part(pot, seed));
  world.push_back(soil_part(pot, seed));
  RouteRequest request;
  request.top = top_of(world);
  if (o.mat) world.push_back(mat_part());
  if (o.route == SeedlingRoute::turntable) world.push_back(turntable_part());
  s.picture.room = room_parts(seed);
  s.picture.world_rays.emplace(world);
  s.picture.room_rays.emplace(s.picture.room);
  request.kind = o.route;
  request.views = o.views;
  request.distance = o.distance.value_or(0);
  request.tremor = o.tremor;
  request.exposure = o.motion_blur;
  request.middle = mat_middle().head<2>();
  s.route = camera_route(request, s.camera.color, seed);
  return s;
}

}  // namespace bole::sim
