// Options of the survey frame.
#pragma once

#include <array>
#include <string_view>

#include "base/option.h"

namespace bole::survey {

// What tells the vertical.
enum class Level { automatic, gravity, stems, ground, none };
constexpr std::array<std::string_view, 5> choice_names(Level) { return {"auto", "gravity", "stems", "ground", "none"}; }

struct FrameOptions {
  Level level = Level::automatic;
  double min_intensity = 100.0;
  int min_target_points = 20;
  double target_size = 0.7;
  double target_views = 2.0;
  double target_distance = 0.0;
  double target_tolerance = 1.0;
  double north_bearing_deg = 0.0;
  double max_tilt_deg = 30.0;
  int min_stems = 5;
};

const OptionTable& option_table(const FrameOptions*);

}  // namespace bole::survey
