// Options of the chain from one LiDAR frame to plant centres (SPEC B), with the paper's values where it gives them.
#pragma once

#include <string>

#include "base/option.h"

namespace bole::rows {

struct LevelOptions {
  double roll_deg = 0, pitch_deg = 0, yaw_deg = 0;
};

struct RegionOptions {
  double x_min = -3, x_max = 3;
  double y_min = 0, y_max = 12;
  double z_min = -1, z_max = 1;
};

struct VoxelOptions {
  double size = 0.1;
};

struct RayGroundOptions {
  double sector_deg = 0.2;
  double sensor_height = 0.4;
  double local_max_slope_deg = 8;
  double general_max_slope_deg = 5;
  double height_threshold = 0.05;
  double reset_distance = 0.2;
};

struct RadiusOptions {
  double radius = 0.3;
  int neighbours_min = 3;
};

struct MeanShiftOptions {
  double bandwidth = 0.3;
  int points_min = 5;
};

struct TrunkOptions {
  double layer_height = 0.1;
  double d_x = 0.12, d_y = 0.12;
  int layers_min = 3;
  double ahead_min = 0;
  std::string centre = "mean";
  double range_sigma = 0.02;
  double reach = 0.3;
  double height_min = 0.3, narrowest = 0;
  double filled_min = 0.6;
};

struct PlaceOptions {
  double x = 0, y = 0;
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
