// Velodyne packets, which the seeds of two targets are made of.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "sensor/core/velodyne_encoder.h"

namespace bole::fuzz {

// The dual-return packets of 40 firing sequences that cross azimuth pi.
inline void encode_packets(const char* sensor_name, const sensor::VelodyneEncoder::Sink& sink) {
  const auto model = sensor::load_sensor_model(sensor_name);
  sensor::VelodyneEncoder encoder(model, sensor::VelodyneReturnMode::dual, sink);
  const std::vector<sensor::LaserEcho> near(model.channels.size(), {3, 7});
  const std::vector<sensor::LaserEcho> far(model.channels.size(), {9, 1});
  for (int s = 0; s < 40; ++s) encoder.add(1.7e9 + s * model.sequence_period_s, 3.13 + 0.0035 * s, near, far);
}

}  // namespace bole::fuzz
