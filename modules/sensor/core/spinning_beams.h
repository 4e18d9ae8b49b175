// The beams of a sensor that turns: from the rotor's azimuth at each firing to points. Decoders of several makers use
// it.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "sensor/core/sensor_model.h"

namespace bole::sensor {

inline constexpr int full_turn_centideg = 36000;

struct VelodyneReturn {
  Eigen::Vector3f position;  // sensor axes: x forward, y left, z up, metres
  float range_m = 0;
  float time_offset_s = 0;    // of this laser's firing, after the first firing of the packet
  std::uint16_t channel = 0;  // index in SensorModel::channels
  std::uint16_t ring = 0;
  std::uint8_t firing = 0;  // index of the block group within the packet, see VelodyneDecoder::firings()
  std::uint8_t intensity = 0;
  std::uint8_t return_number = 1;  // dual return: 1 strongest, 2 last where it differs
};

// The blocks of a packet that fired together: one for a single return, two for a dual return (last, strongest), and one
// per bank of 32 lasers for the HDL-64E and the VLS-128.
struct VelodyneFiring {
  int first_block = 0;
  bool valid = false;           // its first block is one
  double azimuth_centideg = 0;  // of the rotor at its start, [0, 36000)
  double advance_centideg = 0;  // turn until the next firing starts
  double time_offset_s = 0;     // after the first firing of the packet
};

// Where a laser stands in the sensor's axes while it points at `azimuth_rad` (clockwise, its own offset included) and
// `elevation_rad`. Its ranges count from there, less `offsets.range`. The two-point correction is not in it.
Eigen::Vector3d laser_origin(const LaserOffsets& offsets, double azimuth_rad, double elevation_rad);

class SpinningBeams {
 public:
  explicit SpinningBeams(const SensorModel& model);

  std::size_t size() const { return beams_.size(); }

  // Fills advance_centideg from the azimuths. The rotor's advance from one firing to the next is that of the packet;
  // for the last firing it is the mean of the others, and also for firings whose azimuth jumps (damaged packets). A
  // single jump is a masked sector: the sensor sends nothing while the rotor passes it, and the firings after it are
  // later by that time. A packet with one firing has no advance: it gets that of the usual rate.
  void set_advances(double firing_period_s, std::vector<VelodyneFiring>& firings) const;

  // Appends the return of a beam; `sequence_time_s` is the start of its sequence within the firing.
  void append(float range_m, std::uint8_t intensity, std::size_t beam, const VelodyneFiring& firing,
              double firing_period_s, double sequence_time_s, std::uint8_t firing_index, std::uint8_t return_number,
              std::vector<VelodyneReturn>& out) const;

 private:
  struct Beam {
    float cos_elevation, sin_elevation;
    double offset_centideg, time_s;
    std::uint16_t ring;
    LaserOffsets offsets;
    bool off_centre;  // more than its height
  };
  static Eigen::Vector3f point_with_offsets(const Beam& beam, double range_m, double cos_azimuth, double sin_azimuth);
  std::vector<Beam> beams_;
  double usual_rate_centideg_s_ = 0;
};

}  // namespace bole::sensor
