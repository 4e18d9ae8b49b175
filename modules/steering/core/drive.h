// The test of SPEC E5: a line, a turn by hand, and the neighbouring line back.
#pragma once

#include <vector>

#include "base/run.h"
#include "steering/core/tractor.h"

namespace bole::steering {

// Metres about the start of the first line, which leads along +x; the second lies a swath to its left and leads back.
struct DriveSample {
  double time_s = 0;
  int line = 0;              // 1, 2; 0: the turn
  double station_m = 0;      // along +x
  Eigen::Vector2d at, seen;  // control point: true, and as the filter has it
  double error_m = 0;        // true distance from the line, left of the first line's direction positive
  double seen_error_m = 0;
  double reference_error_m = 0;  // as the RTK receiver measures it
  double heading_error_rad = 0, wheel_rad = 0;
  bool fixed = true;  // there was a position of the receiver
};

struct DriveTest {
  std::vector<DriveSample> samples;  // 10 Hz
  double stopped_s = 0;              // time that the tractor stood for want of positions
};

// `disturbances`: replace those drawn. Deterministic for a seed. Throws Error{cancelled}.
DriveTest drive_test(const DriveOptions& options, const Gains& gains, double speed_km_h, std::uint64_t seed,
                     const Run& run, const std::vector<Disturbance>* disturbances = nullptr);

// The gains of the options, from the table of the paper where they are 0.
Gains gains_of(const DriveOptions& options, double speed_km_h);

}  // namespace bole::steering
