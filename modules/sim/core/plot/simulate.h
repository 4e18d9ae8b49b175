// The simulator as one function: a plot, a sensor and a walk in, raw sensor data and the truth beside it out.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/option.h"
#include "base/report.h"
#include "base/run.h"
#include "sim/core/walk/imu.h"
#include "sim/core/walk/walk.h"

namespace bole::sim {

struct SimulationOptions {
  std::string plot = "demo";
  int seed = 1;
  std::string sensor = "vlp32c";
  double rotation_hz = 10;

  std::string walk;
  Carrier carrier = Carrier::person;
  double speed = 1.0;
  double line_spacing = 6.0;
  double sensor_height = 1.7;
  double mount_tilt = 0;
  double gait = 1.0;
  double stand_still = 2.5;
  std::optional<double> max_time;

  double noise = 1.0;
  double divergence = 1.0;
  double dropouts = 0.004;
  double laser_bias = 0.004;
  double pulse_length = 0.40;
  bool bark = true;
  bool bark_facets = false;
  double noise_growth = 0;
  bool dual_return = false;
  double wet = 0;
  double angle_error = 0;

  double turn_on_spot = 0;
  double gap_at = 0;
  double gap = 0;
  double blind_sector = 0;
  double rain = 0;
  bool companion = false;
  double wind = 0;
  double wind_from = 270;
  bool operator_body = false;
  double clock_jitter = 0;

  ImuGrade imu = ImuGrade::none;
  double imu_rate = 200;
  double imu_time_offset = 0;
  bool imu_mount_known = true;

  double trajectory_rate = 100;
  double dem_cell = 0.1;
};
const OptionTable& option_table(const SimulationOptions*);

// Seconds since the Unix epoch at which every simulated recording starts: files hold no time of day, so that the same
// options give the same bytes.
inline constexpr double simulation_epoch_s = 1714551000;  // 2024-05-01 08:10:00 UTC

// Writes into `out_dir` (made when absent): walk.pcap (Velodyne) or frames/NNNNNN.bin with frames/times.txt, trees.csv,
// saplings.csv, targets.csv, trajectory.tum (plot axes), dem.tif, recipe.json, and imu.csv with an inertial unit. Plot
// axes: x east, y north, z up, origin on the ground at the plot centre. The same options give the same bytes at any
// thread count. Throws Error{bad_input} for unknown plots and sensors or options that contradict each other,
// Error{cancelled}, and Error{failed} when a file cannot be written. Asked to finish, it ends the recording early; the
// truth stays complete.
Report simulate(const SimulationOptions& options, const std::filesystem::path& out_dir, const Run& run);

}  // namespace bole::sim
