// The test of SPEC E5 on a simulated tractor: a line, a turn, the neighbouring line, at several speeds.
#pragma once

#include "base/report.h"
#include "base/run.h"
#include "cloud/table.h"
#include "steering/core/drive_options.h"

namespace bole::steering {

struct FieldTest {
  Table
      log;  // a row per fix: run, speed_km_h, line, state (line, turn), time_s, x_m, y_m (navigated), ref_x_m, ref_y_m
            // (true), gnss_x_m, gnss_y_m (NaN in an outage), yaw_deg, offset_m, command_deg, wheel_deg, stopped
  Table lines;  // a_x_m, a_y_m, b_x_m, b_y_m: the first line of every drive
  Report report;
};

// Every speed and repeat is a drive of its own seed; the same options give the same drives. Throws Error{bad_input},
// Error{cancelled}, and Error{failed} when a drive does not come to the end of a line.
FieldTest simulate_field_test(const FieldTestOptions& options, const Run& run);

}  // namespace bole::steering
