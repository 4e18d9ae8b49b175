// Encodes firing sequences into Velodyne packets, for the simulator: the inverse of VelodyneDecoder.
#pragma once

#include <array>
#include <functional>
#include <span>

#include "sensor/core/laser_echo.h"
#include "sensor/core/sensor_model.h"
#include "sensor/core/velodyne_packet.h"

namespace bole::sensor {

class VelodyneEncoder {
 public:
  using Bytes = std::array<std::uint8_t, velodyne_packet_bytes>;
  // Gets each complete packet and the time of its first firing.
  using Sink = std::function<void(const Bytes& packet, double time_s)>;

  // Throws Error{bad_input} where the sensor sends no Velodyne packets, or has no dual return and `mode` is dual.
  VelodyneEncoder(SensorModel model, VelodyneReturnMode mode, Sink sink);

  // One firing sequence: `time_s` of its start (seconds since the Unix epoch), the rotor's azimuth then (radians,
  // clockwise, 0 forward), and one echo per channel. `last` is used in dual mode only (there `strongest` goes to the
  // odd blocks). Ranges are rounded to the quantum; ranges beyond the limits of a packet are no return. Throws
  // Error{failed} on a wrong number of echoes.
  void add(double time_s, double azimuth_rad, std::span<const LaserEcho> strongest,
           std::span<const LaserEcho> last = {});

  // Completes a started packet with empty firings at the last rate of rotation and sends it. Call it once, at the end.
  void flush();

 private:
  void fill(VelodyneBlock& block, int first_record, std::span<const LaserEcho> echoes) const;
  void send();

  SensorModel model_;
  VelodyneReturnMode mode_;
  Sink sink_;
  VelodynePacket packet_;
  double packet_time_s_ = 0, last_time_s_ = 0;
  double last_azimuth_rad_ = 0, advance_rad_ = 0;
  int block_ = 0;     // next one to fill
  int sequence_ = 0;  // within the block (VLP-16: 0 or 1)
};

}  // namespace bole::sensor
