// Where the beams of a scanner point that never repeats its path.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "sensor/core/sensor_model.h"

namespace bole::sim {

struct RosetteAngles {
  double azimuth_rad = 0;  // clockwise from the sensor's forward axis
  double elevation_rad = 0;
};

// Of pulse `n`; pulses of the beams take turns. A limited field of view is covered by two counter-turning wedges, on
// rosettes that are stretched to it. A field of 360 degrees is covered by a mirror that spins while the beams swing
// up and down between its limits, staggered. The ratio of both speeds is irrational, so the figure never repeats. A
// model of the published behaviour (coverage over time), not the maker's secret pattern.
RosetteAngles rosette_angles(const sensor::Rosette& rosette, std::int64_t n);

}  // namespace bole::sim
