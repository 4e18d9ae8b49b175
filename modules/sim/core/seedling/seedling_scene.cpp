#include "sim/core/seedling/seedling_scene.h"

#include <algorithm>
#include <cmath>

#include "sim/core/scene/random.h"
#include "sim/core/seedling/charuco_mat.h"
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

CameraModel draw_color_camera(int width, std::uint64_t seed) {
  Random random(seed, Stream::picture, 1);
  CameraModel full;
  full.width = 1280;
  full.height = 720;
  full.fx = 920 + 6 * random.bounded_normal();
  full.fy = full.fx * (1 + 0.0005 * random.bounded_normal());
  full.cx = 639.5 + 5 * random.bounded_normal();
  full.cy = 359.5 + 5 * random.bounded_normal();
  return full.scaled(width / 1280.0);
}

SeedlingScene build_seedling_scene(const SeedlingSimulationOptions& o) {
  const auto seed = static_cast<std::uint64_t>(o.seed);
  const auto recipe = read_seedling(o.plant);
  const Pot pot = draw_pot(recipe.pot, seed);
  SeedlingScene s{recipe,
                  pot,
                  grow_seedling(recipe, seed, pot.soil_middle()),
                  {},
                  Lighting(seed),
                  SurfaceColors(seed),
                  draw_color_camera(o.width, seed),
                  {}};
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
  request.middle = {CharucoMat::width() / 2, CharucoMat::height() / 2};
  s.route = camera_route(request, s.camera, seed);
  return s;
}

}  // namespace bole::sim
