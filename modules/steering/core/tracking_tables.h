// Statistics and tables of measured passes.
#pragma once

#include <cstdint>
#include <vector>

#include "cloud/table.h"

namespace bole::steering {

struct ErrorSample {
  double time_s, along_m, error_m;
  double controller_m, adjacent_m;  // NaN where unknown
};

struct MeasuredPass {
  std::int64_t run = 1, row = 0;
  int direction = 1;
  double speed_km_h = 0;
  std::vector<ErrorSample> samples;
};

// Mean, standard deviation about it (divide by n) and largest |error|, as the paper's table 2.
struct Spread {
  std::size_t count = 0;
  double mean = 0, sd = 0, max = 0;
};
Spread spread_of(const std::vector<double>& values);  // NaNs are left out; NaN measures without any

struct SpeedErrors {
  double speed_km_h = 0;
  Spread line, adjacent, controller, receiver;
};
std::vector<SpeedErrors> by_speed(const std::vector<MeasuredPass>& passes);
SpeedErrors overall(const std::vector<MeasuredPass>& passes);  // all samples together

Table pass_table(const std::vector<MeasuredPass>& passes);
// speed_km_h, then line_, adjacent_, controller_ and receiver_ mean_m, sd_m, max_m, and published_* of SPEC E5 where
// the paper has that speed; the last row, speed "mean", averages the speeds as the paper does, of each part those at
// which it was measured.
Table summary_table(const std::vector<MeasuredPass>& passes);
Table error_table(const std::vector<MeasuredPass>& passes);

}  // namespace bole::steering
