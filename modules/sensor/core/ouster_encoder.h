// Encodes columns into the packets of an Ouster sensor and writes its JSON file, for the simulator: the inverse of
// OusterDecoder.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "sensor/core/laser_echo.h"
#include "sensor/core/ouster_metadata.h"

namespace bole::sensor {

class OusterEncoder {
 public:
  // Gets each complete packet and the time of its first column.
  using Sink = std::function<void(std::span<const std::uint8_t> packet, double time_s)>;

  static constexpr std::uint16_t lidar_port = 7502;

  // Profile RNG19_RFL8_SIG16_NIR16, or its dual form. Throws Error{bad_input} where the sensor sends no Ouster packets,
  // or a turn at `rotation_hz` is no whole number of columns.
  OusterEncoder(SensorModel model, double rotation_hz, bool dual, Sink sink);

  // The JSON file that goes with the packets. The beams start in the sensor's centre.
  std::string metadata() const;

  // One column: `time_s` (seconds since the Unix epoch), the rotor's azimuth then (radians, clockwise, 0 forward), and
  // one echo per channel: the strongest and, with `dual`, the second strongest (the same range again: none). Ranges are
  // rounded to 1 mm. Columns that are left out are marked as not valid. Throws Error{failed} on a wrong number of
  // echoes.
  void add(double time_s, double azimuth_rad, std::span<const LaserEcho> strongest,
           std::span<const LaserEcho> second = {});

  // Sends a started packet. Call it once, at the end.
  void flush();

 private:
  void start_packet(int first_column, double time_s);
  void put_pixel(std::size_t at, LaserEcho first, LaserEcho second);

  SensorModel model_;
  double rotation_hz_;
  bool dual_;
  Sink sink_;
  int columns_ = 0;  // of a turn
  std::vector<std::uint8_t> packet_;
  int first_column_ = -1, last_column_ = -1;  // of the packet, and the one added last
  std::uint16_t frame_id_ = 0;
  double packet_time_s_ = 0;
};

}  // namespace bole::sensor
