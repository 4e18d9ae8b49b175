// Options of a simulated drive: tractor, receiver, position filter, controller, and the test made of them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/option.h"

namespace bole::steering {

struct TractorOptions {
  double wheelbase = 2.69;
  double max_steering_angle_deg = 40;
  double steering_rate_deg_s = 30;
  double steering_lag = 0.1;
  double steering_delay = 0.05;
  double steering_deadband_deg = 0;
  double steering_offset_deg = 0.3;
  double wheel_disturbance_deg = 0.6;
  double roughness_deg = 0.7;
  double side_slope_deg = 0;
  double slip_per_slope = 0.1;
  double turn_radius = 6;
};

struct ReceiverOptions {
  double rate = 10;
  double white_noise = 0.004;
  double drift = 0.012;
  double drift_time = 300;
  double jumps_per_hour = 0;
  double jump_size = 0.1;
  double jump_time = 30;
  double outages_per_hour = 0;
  double outage_length = 3;
  double heading_noise_deg = 0.2;
  double tilt_noise_deg = 0.2;
  double antenna_forward = 0.8;
  double antenna_left = 0;
  double antenna_up = 2.8;
};

struct FilterOptions {
  double position_sigma = 0.01;
  double acceleration_sigma = 0.3;
  double gate = 5;
  double patience = 2;
  double max_outage = 5;
};

// Preview and gains left open: from the table of the paper at the speed of the drive (published_gains()).
struct ControlOptions {
  std::optional<double> preview;
  std::optional<double> gain_p;
  std::optional<double> gain_i;
  std::optional<double> gain_d;
  double approach_angle_deg = 30;
  double max_command_deg = 15;
  double integral_zone = 0.2;
  double integral_limit_deg = 5;
};

struct DriveOptions : TractorOptions, ReceiverOptions, FilterOptions, ControlOptions {
  int seed = 1;
};

struct FieldTestOptions : DriveOptions {
  std::string speeds = "3 5 7";
  int repeats = 1;
  int rows = 2;
  double row_width = 2.5;
  double run_in = 30;
  double measured_length = 80;
  double direction_deg = 0;
  double start_offset = 0.3;
};

struct TuneOptions : DriveOptions {
  double speed_km_h = 5;
  double first_p = 100;
  double first_preview = 6;
  double start_offset = 0.1;
  double oscillation = 0.005;
};

const OptionTable& option_table(const FieldTestOptions*);
const OptionTable& option_table(const TuneOptions*);

// Speeds of a list like "3 5 7", in km/h. Throws Error{bad_input} for a word that is no number from 0.1 to 40.
std::vector<double> speeds_km_h(const std::string& list);

}  // namespace bole::steering
