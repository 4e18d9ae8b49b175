// What the calibrations of Velodyne units have in common, in whatever form they are written.
#pragma once

#include <string_view>
#include <vector>

#include "sensor/core/sensor_model.h"

namespace bole::sensor {

struct CalibratedLaser {
  double id = 0;
  double elevation_rad = 0, azimuth_offset_rad = 0;  // as in LaserChannel
  LaserOffsets offsets;                              // the vertical one as the file has it
};

// The nominal model of a sensor with so many lasers, with the angles and offsets of the unit. `range_quantum_m` is 0
// where the file does not have it. Throws Error{bad_input}: another number of lasers, one absent or there twice.
SensorModel calibrated_model(std::size_t lasers, double range_quantum_m, const std::vector<CalibratedLaser>& unit);

// A number as calibrations write it, with a dot whatever the locale is, at most `limit` in size. `name` is for the
// message. Throws Error{bad_input}.
double calibration_number(std::string_view text, std::string_view name, double limit);

}  // namespace bole::sensor
