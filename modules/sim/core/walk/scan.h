// A sensor carried along a walk: every firing in order of time.
#pragma once

#include <cstdint>
#include <functional>
#include <numbers>
#include <span>
#include <vector>

#include "base/run.h"
#include "sensor/core/sensor_model.h"
#include "sim/core/scene/beam.h"
#include "sim/core/scene/turns.h"
#include "sim/core/walk/walk.h"

namespace bole::sim {

// The rotor starts looking backwards, where frames are cut.
inline constexpr double first_azimuth_rad = std::numbers::pi;

// One firing sequence: every laser once. A scanner without lines has no rotor: there `azimuth_rad` goes round once in a
// frame, and a sequence is a run of pulses, whose aims it carries.
struct FiringSequence {
  std::int64_t index = 0;
  double time_s = 0;                          // of its start, since the start of the recording
  double azimuth_rad = 0;                     // of the rotor then, clockwise, [0, 2 pi)
  double turn_rad_s = 0;                      // of the rotor
  std::span<const sensor::LaserEcho> echoes;  // by channel
  std::span<const sensor::LaserEcho> last{};  // by channel; empty without dual return
  std::span<const Aim> aims{};                // by pulse; empty for scanners with lines
  double pulse_period_s = 0;                  // between the pulses of `aims`

  // Direction of a pulse, and its time after the start of the sequence.
  Aim aim(const sensor::SensorModel& sensor, std::size_t pulse) const;
  double delay_s(const sensor::SensorModel& sensor, std::size_t pulse) const;
};

struct ScanStatistics {
  std::int64_t pulses = 0, returns = 0;
};

// Fires the sensor from time 0 to the end of the walk and hands the sequences on in order. Works in parallel, in
// batches; the result does not depend on the number of threads. Asked to finish, it ends early.
ScanStatistics scan(const sensor::SensorModel& sensor, const BeamParameters& beam, const RayScene& scene,
                    const Walk& walk, double rotation_hz, std::uint64_t seed, const Run& run,
                    const std::function<void(const FiringSequence&)>& sink);

}  // namespace bole::sim
