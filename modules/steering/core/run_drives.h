// Whole experiments: tests at several speeds, cases of trouble, and tuning.
#pragma once

#include "base/report.h"
#include "steering/core/steering_statistics.h"

namespace bole::steering {

struct DriveResult {
  Table figures;  // of figures_table()
  Table cases;    // speed_km_h, case (jump, outage), size (m, s), peak_error_m (true, from its start to 30 s after it),
                  // stopped_s
  Table track;    // of the first test of every speed: speed_km_h, time_s, line, station_m, error_m, seen_error_m,
                  // reference_error_m, heading_error_deg, wheel_deg, x_m, y_m, fixed
  Report report;
};

// Tests at every speed of the options, each once more with a perfect receiver on the same ground; then jumps of 0.1,
// 0.3 and 1 m that last and outages of 2, 5 and 15 s, put in the middle of the first line.
DriveResult run_drives(const DriveOptions& options, const Run& run);

struct TuneOptions : DriveOptions {
  double start_preview = 5, start_p = 100;
  double oscillation = 2.5;
};
const OptionTable& option_table(const TuneOptions*);

struct TuneResult {
  Table gains;  // speed_km_h, preview_m, p, i, d, and published_preview_m ... of the paper's table
  Table steps;  // speed_km_h, parameter, value, oscillation_deg: what was tried
  Report report;
};

// The tuning of the paper, on the simulated tractor: at a constant speed the preview shrinks metre by metre until the
// wheel swings, then plus one; P grows by 5 until it swings; D grows by 1 from 0 until it does not; I is half of the
// largest (steps of 2, up to 40) that does not bring the swing back. Swinging: a scatter of the wheel angle over the
// last half of the line above `oscillation`.
TuneResult tune(const TuneOptions& options, const Run& run);

}  // namespace bole::steering
