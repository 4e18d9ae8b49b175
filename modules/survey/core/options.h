// Options of the survey frame.
#pragma once

#include <string>

#include "base/option.h"

namespace bole::survey {

struct FrameOptions {
  std::string level = "stems";
  double intensity_min = 100.0;
  int target_points_min = 20;
  double target_size_m = 0.7;
  double target_views_m = 2.0;
  double target_distance_m = 0.0;
  double target_tolerance_m = 1.0;
  double north_bearing_deg = 0.0;
  double most_tilt_deg = 30.0;
  int stems_min = 5;
};

const OptionTable& option_table(const FrameOptions*);

}  // namespace bole::survey
