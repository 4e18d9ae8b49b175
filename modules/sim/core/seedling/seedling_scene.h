// A whole simulated scene: the plant, its surroundings, the camera and where it goes.
#pragma once

#include "camera/camera_model.h"
#include "sim/core/seedling/camera_route.h"
#include "sim/core/seedling/picture_scene.h"
#include "sim/core/seedling/plant_form.h"
#include "sim/core/seedling/seedling_options.h"
#include "sim/core/seedling/surface_color.h"
#include "sim/core/seedling/surroundings.h"

namespace bole::sim {

struct SeedlingScene {
  SeedlingRecipe recipe;
  Pot pot;
  PlantForm plant;
  PictureScene picture;  // plant, pot, soil and mat are its `world`; not lighted yet
  Lighting lighting;
  SurfaceColors colors;
  RgbdCamera camera;
  std::vector<RouteView> route;
};

// Throws Error{bad_input} for unknown recipes.
SeedlingScene build_seedling_scene(const SeedlingSimulationOptions& options);

// Cameras like those of a RealSense D435, with small constants of their own. Stereo and time of flight have a depth
// camera beside the colour camera, whether its pictures will be registered or not.
RgbdCamera draw_camera(const SeedlingSimulationOptions& options);

}  // namespace bole::sim
