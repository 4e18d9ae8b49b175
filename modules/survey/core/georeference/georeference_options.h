// Options of the place of a plot on the earth.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "base/option.h"

namespace bole::survey {

enum class ControlHeight { target, ground };
constexpr std::array<std::string_view, 2> choice_names(ControlHeight) { return {"target", "ground"}; }

// one: metres on the plane are metres in the plot; grid: times the scale of the projection and the reduction of the
// height.
enum class GridScale { one, grid };
constexpr std::array<std::string_view, 2> choice_names(GridScale) { return {"one", "grid"}; }

enum class BearingKind { grid, magnetic, geographic };
constexpr std::array<std::string_view, 3> choice_names(BearingKind) { return {"grid", "magnetic", "true"}; }

struct GeoreferenceOptions {
  std::string file;
  std::string crs;
  std::optional<double> control_sd, height_sd;
  double map_sd = 0.01;
  double max_residual = 1.0;
  bool leave_out_blunders = true;
  std::optional<GridScale> scale;
  ControlHeight height_of = ControlHeight::target;
  bool level = true;
  double level_sd_deg = 0.1;
  std::optional<double> easting, northing, latitude_deg, longitude_deg, height;
  std::optional<double> bearing_deg, declination_deg;
  BearingKind bearing_kind = BearingKind::magnetic;
  double bearing_sd_deg = 1.0;
  std::optional<double> clock_offset, track_sd;
  double clock_window = 30.0;
  double lever_x = 0, lever_y = 0, lever_z = 0;
  double lever_sd = 0.3;
};

const OptionTable& option_table(const GeoreferenceOptions*);

// Where control_sd and height_sd are left open and the residuals cannot tell.
inline constexpr double usual_control_sd_m = 0.02, usual_height_sd_m = 0.03;

}  // namespace bole::survey
