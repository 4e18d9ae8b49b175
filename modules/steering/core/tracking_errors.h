// How well lines were followed, from a log: straight-line error and adjacent-row error (SPEC E5).
#pragma once

#include <optional>
#include <vector>

#include "base/option.h"
#include "base/report.h"
#include "base/run.h"
#include "cloud/table.h"

namespace bole::steering {

struct ErrorOptions {
  std::optional<double> row_width;  // left open: from the log, where it has the fact row_width_m
  double run_in = 30;
  double run_out = 3;
  double min_length = 20;
  double max_angle_deg = 10;
  double speed_step_km_h = 1;
  double max_gap = 5;
};

const OptionTable& option_table(const ErrorOptions*);

struct TrackingErrors {
  Table passes;   // a row per pass along a line
  Table summary;  // a row per speed and one of their averages, the paper's figures beside
  Table errors;   // a row per fix on a pass: run, pass, time_s, along_m, error_m, controller_m, receiver_m, adjacent_m
  Report report;
};

// `log`: time_s, x_m, y_m as the controller navigated; run, speed_km_h where known. Where the tractor really was comes
// from ref_x_m and ref_y_m of the log, else from `reference` (time_s, x_m, y_m: interpolated), else the log is taken
// for the truth and the receiver's share is unknown. `lines`: a_x_m, a_y_m, b_x_m, b_y_m of the first line, or of any
// one whose column line counts row widths to the left of it (plan_lines); else the longest straight stretch of each run
// gives it. The row width comes from the options, else from the fact row_width_m of the log or the lines.
//   error_m       true distance from the line, positive left of the way driven;
//   controller_m  navigated distance from the line: what the controller left; receiver_m = controller_m - error_m;
//   adjacent_m    true distance from the neighbouring pass driven before, minus the row width.
// Throws Error{bad_input} when columns are missing, times do not rise or no pass is found; Error{cancelled}.
TrackingErrors tracking_errors(const Table& log, const Table* lines, const Table* reference,
                               const ErrorOptions& options, const Run& run);

}  // namespace bole::steering
