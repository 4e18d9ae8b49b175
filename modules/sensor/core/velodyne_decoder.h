// Decodes Velodyne packets into points. Every laser gets the azimuth and time of its own firing.
#pragma once

#include <optional>
#include <vector>

#include "sensor/core/sensor_model.h"
#include "sensor/core/spinning_beams.h"
#include "sensor/core/velodyne_packet.h"

namespace bole::sensor {

class VelodyneDecoder {
 public:
  // Throws Error{bad_input} when the model has no Velodyne packets.
  explicit VelodyneDecoder(SensorModel model);

  const SensorModel& model() const { return model_; }

  // The firings of a packet, each with its own azimuth and its advance (SpinningBeams::set_advances).
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
  void append(const VelodyneRecord& record, std::size_t beam, const VelodyneFiring& firing, double sequence_time_s,
              std::uint8_t firing_index, std::uint8_t return_number, std::vector<VelodyneReturn>& out) const;
  void append_pair(const VelodyneBlock& block, const VelodyneBlock* strongest, std::size_t record, std::size_t beam,
                   const VelodyneFiring& firing, double sequence_time_s, std::uint8_t index,
                   std::vector<VelodyneReturn>& out) const;
  void decode_banks(const VelodynePacket& packet, const VelodyneFiring& firing, std::uint8_t index,
                    std::vector<VelodyneReturn>& out) const;

  SensorModel model_;
  SpinningBeams beams_;
  std::size_t banks_ = 1;  // of 32 lasers, where there are more
};

// The sensor model by the factory bytes of a packet (HDL-64E, VLS-128: by its block flags), if it is in
// resources/sensors.
std::optional<SensorModel> recognise_velodyne(const VelodynePacket& packet);

}  // namespace bole::sensor
