// Options of the terrain model.
#pragma once

#include <string>

#include "base/option.h"

namespace bole::ground {

struct GroundOptions {
  std::string method = "tin";
  double cell_m = 0.25;
  double seed_m = 4.0;
  double max_slope_deg = 50.0;
  double max_angle_deg = 15.0;
  double max_distance_m = 0.6;
  double roughness_m = 0.10;
  double band_m = 0.30;
  double tolerance_m = 0.15;
  double noise_depth_m = 0.30;
  double fill_distance_m = 10.0;
  bool keep_classes = true;
};

const OptionTable& option_table(const GroundOptions*);

}  // namespace bole::ground
