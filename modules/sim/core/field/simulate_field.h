// A field robot with a Livox Horizon in a planted field: frames, what its IMU says, and the truth.
#pragma once

#include <string>
#include <vector>

#include "base/option.h"
#include "base/report.h"
#include "base/run.h"
#include "cloud/point_cloud.h"
#include "cloud/table.h"

namespace bole::sim {

struct FieldSimulationOptions {
  std::string field = "tubes1";
  int seed = 1;
  double integration = 0.1;
  int frames = 1;
  double speed = 0;
  double tilt = 2;
  double sway = 0.3;
  double imu_noise = 0.05;
  double imu_bias = 0.1;
  double noise = 1;
  double mark_noise = 0.01;
};
const OptionTable& option_table(const FieldSimulationOptions*);

// `frames`: points in sensor axes, x right, y ahead, z up, with intensity and time (seconds since the start) and
// tree_id (truth: the plant that the pulse met). The robot keeps to a straight line; every pulse is fired from the pose
// of its own microsecond.
struct FieldScan {
  std::vector<PointCloud> frames;
  Table attitude;  // of the IMU, 200 Hz: time_s, roll_deg, pitch_deg, yaw_deg (0); p_level = Ry(pitch) Rx(roll) p
  Table poses;     // true, one per frame at its middle: frame, time_s, x_m, y_m, z_m, heading_deg, roll_deg, pitch_deg,
                   // yaw_deg (of rows.place: heading - 90)
  Table marks;     // three antennas for resection: name, x_m, y_m, z_m (as the receiver gives them), range_m, and
                   // seen_x_m, seen_y_m, seen_z_m (as the LiDAR sees them, levelled by the IMU)
  Table plants;    // the truth: row_id, number, x_m, y_m, state, diameter_mm, tree_id
  Table rows;      // the truth: row_id, angle_deg, x0_m, y0_m, x1_m, y1_m, plants
  Report report;
};

// The same options give the same data at any thread count. Throws Error{bad_input} for unknown fields and
// Error{cancelled}.
FieldScan simulate_field(const FieldSimulationOptions& options, const Run& run);

}  // namespace bole::sim
