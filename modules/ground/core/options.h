// Options of the terrain model.
#pragma once

#include <array>
#include <string_view>

#include "base/option.h"

namespace bole::ground {

enum class GroundMethod { tin, lowest };
constexpr std::array<std::string_view, 2> choice_names(GroundMethod) { return {"tin", "lowest"}; }

struct GroundOptions {
  GroundMethod method = GroundMethod::tin;
  double cell = 0.25;
  double seed = 4.0;
  double max_slope_deg = 50.0;
  double max_angle_deg = 15.0;
  double max_distance = 0.6;
  double roughness = 0.10;
  double band = 0.30;
  double tolerance = 0.15;
  double noise_depth = 0.30;
  double fill_distance = 10.0;
  bool keep_classes = true;
};

const OptionTable& option_table(const GroundOptions*);

}  // namespace bole::ground
