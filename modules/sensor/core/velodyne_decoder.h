// Decodes Velodyne packets into points. Every laser gets the azimuth and time of its own firing.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "sensor/core/sensor_model.h"
#include "sensor/core/velodyne_packet.h"

namespace bole::sensor {

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

// The blocks of a packet that fired together: one for a single return, two for a dual return (last, strongest) and for
// the upper and lower lasers of the HDL-64E.
struct VelodyneFiring {
  int first_block = 0;
  bool valid = false;           // its first block is one
  double azimuth_centideg = 0;  // of the rotor at its start, [0, 36000)
  double advance_centideg = 0;  // turn until the next firing starts
  double time_offset_s = 0;     // after the first firing of the packet
};

class VelodyneDecoder {
 public:
  // Throws Error{bad_input} when the model has no Velodyne packets.
  explicit VelodyneDecoder(SensorModel model);

  const SensorModel& model() const { return model_; }

  // The firings of a packet, each with its own azimuth. The rotor's advance from one firing to the next is that of the
  // packet; for the last firing it is the mean of the others, and also for blocks whose azimuth jumps (damaged
  // packets). A single jump is a masked sector: the sensor sends nothing while the rotor passes it, and the firings
  // after it are later by that time.
  std::vector<VelodyneFiring> firings(const VelodynePacket& packet) const;
  void firings(const VelodynePacket& packet, std::vector<VelodyneFiring>& out) const;

  // Appends the returns of the firings [first, last) in order of firing. Returns without range are left out. In dual
  // mode a last return that equals the strongest is not repeated.
  void decode(const VelodynePacket& packet, std::vector<VelodyneReturn>& out) const;
  void decode(const VelodynePacket& packet, const std::vector<VelodyneFiring>& firings, std::size_t first,
              std::size_t last, std::vector<VelodyneReturn>& out) const;

  // Time from the first firing of a packet to that of the next.
  double packet_period_s(bool dual) const;
  int blocks_per_firing(bool dual) const;
  double firing_period_s() const { return model_.sequence_period_s * model_.sequences_per_block; }

 private:
  struct Beam {
    float cos_elevation, sin_elevation;
    double offset_centideg, time_s;
    std::uint16_t ring;
  };
  void shift_behind_blind_sector(double mean_advance_centideg, std::vector<VelodyneFiring>& firings) const;
  void append(const VelodyneRecord& record, std::size_t beam, const VelodyneFiring& firing, double sequence_time_s,
              std::uint8_t firing_index, std::uint8_t return_number, std::vector<VelodyneReturn>& out) const;

  SensorModel model_;
  std::vector<Beam> beams_;
};

// The sensor model by the factory bytes of a packet (HDL-64E: by its block flags), if it is in resources/sensors.
std::optional<SensorModel> recognise_velodyne(const VelodynePacket& packet);

}  // namespace bole::sensor
