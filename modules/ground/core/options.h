// Options of the terrain model.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "base/option.h"

namespace bole::ground {

enum class GroundMethod { tin, lowest, normalised };
constexpr std::array<std::string_view, 3> choice_names(GroundMethod) { return {"tin", "lowest", "normalised"}; }

struct GroundOptions {
  // What is left open follows the cloud: the method its heights, the lengths its density (scales.h).
  std::optional<GroundMethod> method;
  std::optional<double> cell, seed;
  double max_slope_deg = 50.0;
  std::optional<double> max_angle_deg, max_distance, roughness, band, tolerance, noise_depth, fill_distance;
  bool keep_classes = true;
};

const OptionTable& option_table(const GroundOptions*);

}  // namespace bole::ground
