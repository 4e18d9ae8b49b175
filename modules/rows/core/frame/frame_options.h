// Options of the chain from one LiDAR frame to plant centres (SPEC B), with the paper's values where it gives them.
#pragma once

#include <array>
#include <string_view>

#include "base/option.h"

namespace bole::rows {

struct LevelOptions {
  double roll_deg = 0;
  double pitch_deg = 0;
  double yaw_deg = 0;
};

struct RegionOptions {
  double min_x = -3, max_x = 3;
  double min_y = 0, max_y = 12;
  double min_z = -1, max_z = 1;
};

struct VoxelOptions {
  double size = 0.1;
};

struct RayGroundOptions {
  double sector_deg = 0.2;
  double sensor_height = 0.4;
  double max_local_slope_deg = 8;
  double max_general_slope_deg = 5;
  double height_threshold = 0.05;
  double reset_distance = 0.2;
};

struct RadiusOptions {
  double radius = 0.3;
  int min_neighbours = 3;
};

struct MeanShiftOptions {
  double bandwidth = 0.3;
  int min_points = 5;
};

// mean: of the trunk points; face: the axis behind the side that the sensor sees.
enum class TrunkCentre { mean, face };
constexpr std::array<std::string_view, 2> choice_names(TrunkCentre) { return {"mean", "face"}; }

struct TrunkOptions {
  double layer_height = 0.1;
  double max_extent_x = 0.12, max_extent_y = 0.12;
  int min_layers = 3;
  double min_ahead = 0;
  TrunkCentre centre = TrunkCentre::mean;
  double range_sigma = 0.02;
  double reach = 0.3;
  double min_diameter = 0;
  double min_height = 0.3;
  double min_filled = 0.6;
};

struct PlaceOptions {
  double x = 0;
  double y = 0;
  double yaw_deg = 0;
};

const OptionTable& option_table(const PlaceOptions*);
const OptionTable& option_table(const LevelOptions*);
const OptionTable& option_table(const RegionOptions*);
const OptionTable& option_table(const VoxelOptions*);
const OptionTable& option_table(const RayGroundOptions*);
const OptionTable& option_table(const RadiusOptions*);
const OptionTable& option_table(const MeanShiftOptions*);
const OptionTable& option_table(const TrunkOptions*);

}  // namespace bole::rows
