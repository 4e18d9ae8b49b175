// Options of `bole simulate-seedling`.
#pragma once

#include <optional>
#include <string>

#include "base/option.h"
#include "sim/core/seedling/camera_route.h"

namespace bole::sim {

// exact: depth along exact rays; kinect: structured light; stereo: an infrared pair; tof: time of flight.
enum class SeedlingSensor { exact, kinect, stereo, tof };
constexpr std::array<std::string_view, 4> choice_names(SeedlingSensor) { return {"exact", "kinect", "stereo", "tof"}; }

struct SeedlingSimulationOptions {
  std::string plant = "citrus";
  int seed = 1;
  SeedlingRoute route = SeedlingRoute::orbit;
  int views = 100;
  std::optional<double> distance;
  double tremor = 1;
  int width = 1280;
  SeedlingSensor sensor = SeedlingSensor::kinect;
  int depth_width = 640;
  bool registered = true;
  double depth_scale = 1000;
  double noise = 1;
  double point_spread = 0.45;
  double exposure_drift = 0;
  double motion_blur = 0;
  double distortion = 0;
  double sway = 0;
  bool mat = true;
  bool given_poses = true;
  double stem_height = 0.030;
  int samples = 2;
  int light_samples = 128;
};
const OptionTable& option_table(const SeedlingSimulationOptions*);

}  // namespace bole::sim
