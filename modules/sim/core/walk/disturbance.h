// What spoils a recording in the field: lost packets, a covered sector, drops of rain, a person beside the bearer.
#pragma once

#include <cstdint>
#include <vector>

#include "sensor/core/sensor_model.h"
#include "sim/core/walk/scan.h"
#include "sim/core/walk/walk.h"

namespace bole::sim {

struct DisturbanceParameters {
  double gap_at_s = 0, gap_s = 0;  // packets of that stretch are missing; gap_s 0: none
  double blind_sector_rad = 0;     // about the back of the sensor
  double rain = 0;                 // share of pulses that end at a drop
  bool companion = false;          // a person walks round the bearer
  double sensor_height_m = 1.7;
  double noise = 1;  // factor on the range noise, as in BeamParameters
};

class Disturbance {
 public:
  Disturbance(const DisturbanceParameters& parameters, const sensor::SensorModel& sensor, const Walk& walk,
              std::uint64_t seed);

  // The sequence as it is recorded, valid until the next call; false when it is lost. Whole packets are lost.
  bool apply(FiringSequence& sequence);

  // Where the companion stands, relative to the bearer's feet: a circle of 1.2 m, once in 20 s.
  static Eigen::Vector2d companion_offset(double time_s);
  static constexpr double companion_radius_m = 0.22, companion_height_m = 1.75;

 private:
  bool in_blind_sector(double azimuth_rad) const;
  // Range along a ray from the sensor to the companion; 0: the ray passes.
  double range_to_companion(const Pose& T_plot_sensor, const Eigen::Vector3d& in_sensor, double time_s) const;

  DisturbanceParameters parameters_;
  const sensor::SensorModel& sensor_;
  const Walk& walk_;
  std::uint64_t seed_;
  std::vector<sensor::LaserEcho> echoes_;
};

}  // namespace bole::sim
