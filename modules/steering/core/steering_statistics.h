// What a drive is judged by: errors of a line and of neighbouring lines (SPEC E5, table 2 of the paper).
#pragma once

#include <string>
#include <vector>

#include "cloud/table.h"
#include "steering/core/drive.h"

namespace bole::steering {

struct ErrorFigures {
  double mean_m = 0, sd_m = 0, most_m = 0;  // most: largest absolute value
};

// Mean, standard deviation (divided by n) and largest absolute value.
ErrorFigures figures_of(const std::vector<double>& errors);

// One speed: figures of every test, then their means; standard deviations as roots of mean squares.
struct SpeedFigures {
  double speed_km_h = 0;
  Gains gains;
  int tests = 0;
  ErrorFigures line, adjacent;  // as the reference receiver measures them; `most` is the mean over the tests
  double worst_line_m = 0, worst_adjacent_m = 0;
  double true_sd_m = 0;        // of the true line error
  double receiver_sd_m = 0;    // of what the filter gets wrong: seen minus true
  double controller_sd_m = 0;  // of the error that the controller saw
  double perfect_sd_m = 0;     // of the line error with a perfect receiver, the same ground
  double stopped_s = 0;
};

// Samples that count of one line: beyond the way to settle in.
std::vector<const DriveSample*> counted(const DriveTest& test, int line, const DriveOptions& options);

// Deviations of the distance of the two lines from the swath, by station.
std::vector<double> adjacent_errors(const DriveTest& test, const DriveOptions& options);

SpeedFigures judge(const std::vector<DriveTest>& tests, const std::vector<DriveTest>& perfect,
                   const DriveOptions& options, const Gains& gains, double speed_km_h);

// speed_km_h, preview_m, p, i, d, tests, line_mean_m, line_sd_m, line_max_m, adjacent_mean_m, adjacent_sd_m,
// adjacent_max_m, the published figures of each (published_...; NaN at speeds the paper has not), true_sd_m,
// receiver_sd_m, controller_sd_m, perfect_sd_m, worst_line_m, worst_adjacent_m.
Table figures_table(const std::vector<SpeedFigures>& speeds);

}  // namespace bole::steering
