// Encodes firings into the packets of a PandarXT-32 or Pandar40P, for the simulator: the inverse of HesaiPackets.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "sensor/core/hesai_decoder.h"
#include "sensor/core/laser_echo.h"

namespace bole::sensor {

class HesaiEncoder {
 public:
  // Gets each complete packet and the time of its first firing.
  using Sink = std::function<void(std::span<const std::uint8_t> packet, double time_s)>;

  // `dual`: the last and the strongest return. Throws Error{bad_input} where the sensor sends no Hesai packets that are
  // known.
  HesaiEncoder(SensorModel model, double rotation_hz, bool dual, Sink sink);

  // The correction file (CSV) of the unit.
  std::string correction() const;

  // One firing of all lasers: `time_s` of its start (seconds since the Unix epoch), the rotor's azimuth then (radians,
  // clockwise, 0 forward), and one echo per channel. `last` is used with `dual` only. Ranges are rounded to 4 mm.
  // Throws Error{failed} on a wrong number of echoes.
  void add(double time_s, double azimuth_rad, std::span<const LaserEcho> strongest,
           std::span<const LaserEcho> last = {});

  // Completes a started packet with empty firings and sends it. Call it once, at the end.
  void flush();

 private:
  void put_block(int block, double azimuth_rad, std::span<const LaserEcho> echoes);
  void send();

  SensorModel model_;
  const HesaiLayout* layout_;
  double turn_rad_s_;
  bool dual_;
  Sink sink_;
  std::vector<std::uint8_t> packet_;
  int block_ = 0;  // next one to fill
  double packet_time_s_ = 0, last_time_s_ = 0, last_azimuth_rad_ = 0;
};

}  // namespace bole::sensor
