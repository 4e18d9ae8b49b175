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
  CameraModel camera;  // of colour
  std::vector<RouteView> route;
};

// Throws Error{bad_input} for unknown recipes.
SeedlingScene build_seedling_scene(const SeedlingSimulationOptions& options);

// Colour camera like that of a RealSense D435, with small constants of its own.
CameraModel draw_color_camera(int width, std::uint64_t seed);

}  // namespace bole::sim
