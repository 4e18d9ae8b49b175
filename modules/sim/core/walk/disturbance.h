// What spoils a recording in the field: lost packets, a covered sector, drops of rain, a person beside the operator,
// the operator's own body, a clock that is not exact.
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
  bool companion = false;          // a person walks round the operator
  bool operator_body = false;      // the operator stands in the beams
  double clock_jitter_s = 0;       // standard deviation of the time stamps' error
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

  // Where the operator's body stands, relative to the sensor: behind a sensor in the hand, before one on the back. It
  // sways with each step.
  Eigen::Vector2d operator_offset(double time_s) const;
  static constexpr double operator_radius_m = 0.2, operator_height_m = 1.75;
  // Error of the time stamps: wanders within seconds, with a little of its own in each packet.
  double clock_error_s(double time_s) const;

 private:
  bool in_blind_sector(double azimuth_rad) const;
  // Range along a ray from the sensor to an upright person; 0: the ray passes.
  double range_to_person(const Eigen::Vector3d& ray, const Eigen::Vector2d& middle, double radius_m,
                         double height_m) const;
  struct Pulse {
    sensor::LaserEcho *strongest = nullptr, *last = nullptr;  // last: null without dual return
    Eigen::Vector3d ray;                                      // in plot axes
    double azimuth_rad = 0, time_s = 0;
  };
  void disturb(const Pulse& pulse, class Random& random) const;

  DisturbanceParameters parameters_;
  const sensor::SensorModel& sensor_;
  const Walk& walk_;
  std::uint64_t seed_;
  std::vector<sensor::LaserEcho> echoes_, last_;
};

}  // namespace bole::sim
