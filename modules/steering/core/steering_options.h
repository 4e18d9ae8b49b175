// Options of the simulated drive, of the filter, and of the analysis of logs.
#pragma once

#include <string>
#include <vector>

#include "base/option.h"

namespace bole::steering {

// Gains of the preview-follow PID (SPEC E4, eq. 18): wheel angle in degrees per metre (P), per metre and second (I),
// and per metre per second of V tan(alpha) (D, in the text K_t). The paper prints no units; with these the loop is
// damped as it describes.
struct Gains {
  double preview_m = 0, p = 0, i = 0, d = 0;
};

// Table 1 of the paper at 3, 5, 7 km/h, linear in between, held outside.
Gains table_gains(double speed_km_h);

struct FilterOptions {
  double position_sigma = 0.03;
  double acceleration_sigma = 0.3;
  double gate = 5;
  double patience = 2;
};

struct DriveOptions : FilterOptions {
  std::string speeds = "3, 5, 7";
  int seed = 1;
  int tests = 5;
  double length = 100;
  double settle = 15;
  double swath = 2.5;
  double start_offset = 0.4;
  // Gains; 0: those of the table.
  double preview = 0, gain_p = 0, gain_i = 0, gain_d = 0;
  // Tractor.
  double wheelbase = 2.6;
  double steering_lag = 0.1, steering_delay = 0.05, steering_rate = 30, steering_limit = 35, dead_band = 0.15;
  double line_limit = 10;
  double cross_slope = 0, slip = 0.15;
  double roughness = 0.6;
  // Receiver and attitude.
  double noise = 0.005;
  double drift = 0.025, drift_time = 900;
  double wander = 0.008, wander_time = 15;
  double jumps_per_hour = 4, jump_size = 0.08, jump_time = 4;
  double outages_per_hour = 4, outage_time = 2;
  double outage_stop = 6;
  double heading_noise = 0.1, attitude_noise = 0.2;
  double antenna_ahead = 1.2, antenna_left = 0, antenna_up = 2.9;
  bool lever_arm = true;
  double reference_noise = 0.006;
};

struct LogOptions {
  double swath = 0;
  double settle = 15;
  double line_min = 30;
  double turn = 20;
  double bend = 0.5;
};

const OptionTable& option_table(const FilterOptions*);
const OptionTable& option_table(const DriveOptions*);
const OptionTable& option_table(const LogOptions*);

// "3, 5, 7" as numbers. Throws Error{bad_input} unless each is a speed from 0.5 to 30 km/h.
std::vector<double> speeds_of(const std::string& text);

}  // namespace bole::steering
