// Decodes Ouster packets into points and inertial samples. No file is needed: captures and bags call it with the bytes.
// Source: Ouster software user manuals, "Lidar Data Packet Format" and "Coordinate Frames and XYZ Calculation".
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "cloud/inertial.h"
#include "sensor/core/ouster_metadata.h"

namespace bole::sensor {

struct OusterReturn {
  Eigen::Vector3f position;  // sensor axes: x forward, y left, z up, metres
  float range_m = 0;
  std::int64_t time_ns = 0;  // of its column, on the clock of the sensor
  std::uint16_t column = 0;  // measurement id
  std::uint16_t ring = 0;
  std::uint8_t reflectivity = 0;
  std::uint8_t return_number = 1;  // dual return: 1 strongest, 2 second strongest
};

// What a lidar packet says of itself.
struct OusterPacketHead {
  std::uint16_t frame_id = 0;
  int valid_columns = 0;
  std::int64_t first_time_ns = 0, last_time_ns = 0;  // of its valid columns; 0 where there is none
  std::optional<std::uint64_t> serial_number;        // legacy packets have none
};

class OusterDecoder {
 public:
  explicit OusterDecoder(OusterMetadata metadata);

  const OusterMetadata& metadata() const { return metadata_; }
  std::size_t lidar_packet_bytes() const;
  static constexpr std::size_t imu_packet_bytes = 48;

  // Nothing where the length is another one.
  std::optional<OusterPacketHead> head(std::span<const std::uint8_t> packet) const;

  // Appends the returns of the valid columns of a packet with `head`, in order of its columns. Ranges of zero (no
  // return), columns that the frame does not have and columns with an impossible time are left out.
  void decode(std::span<const std::uint8_t> packet, std::vector<OusterReturn>& out) const;

  // A legacy inertial packet (48 bytes). The time is that of its gyroscope, in seconds on the clock of the sensor.
  static std::optional<InertialSample> inertial_sample(std::span<const std::uint8_t> packet);

 private:
  struct Beam {
    double cos_elevation, sin_elevation, cos_azimuth, sin_azimuth;
    std::uint16_t ring;
  };
  struct Column {
    std::span<const std::uint8_t> pixels;
    std::int64_t time_ns;
    std::uint16_t id, frame_id;
    bool valid;
  };
  Column column(std::span<const std::uint8_t> packet, int index) const;
  struct Encoder {
    double cosine, sine;
  };
  Eigen::Vector3f position(const Beam& beam, const Encoder& encoder, double range_m) const;

  OusterMetadata metadata_;
  std::vector<Beam> beams_;
  double beam_origin_m_ = 0;  // from the lidar's origin to that of a beam
};

}  // namespace bole::sensor
