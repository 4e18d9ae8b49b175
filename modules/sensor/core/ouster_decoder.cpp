#include "sensor/core/ouster_decoder.h"

#include <array>
#include <bit>
#include <cmath>
#include <numbers>

#include "base/angles.h"

namespace bole::sensor {
namespace {

using Bytes = std::span<const std::uint8_t>;
constexpr std::size_t packet_header = 32, packet_footer = 32;  // of all profiles but the legacy one

// Where a pixel keeps range and reflectivity of each return. Ranges are little endian.
struct PixelLayout {
  std::size_t bytes;
  int returns;
  std::size_t range_bytes;
  std::uint32_t range_mask;
  double metres_per_count;
  std::array<std::size_t, 2> range_at, reflectivity_at;
  std::array<std::size_t, 2> signal_at = {0, 0};  // 0: none
};

const PixelLayout& layout_of(OusterProfile profile) {
  static constexpr std::array layouts{
      PixelLayout{12, 1, 4, 0xFFFFF, 1e-3, {0, 0}, {4, 0}}, PixelLayout{12, 1, 4, 0x7FFFF, 1e-3, {0, 0}, {4, 0}},
      PixelLayout{16, 2, 4, 0x7FFFF, 1e-3, {0, 4}, {3, 7}, {8, 10}}, PixelLayout{4, 1, 2, 0x7FFF, 8e-3, {0, 0}, {2, 0}},
      PixelLayout{8, 2, 2, 0x7FFF, 8e-3, {0, 4}, {2, 6}}};
  return layouts[static_cast<std::size_t>(profile)];
}

struct ColumnLayout {
  std::size_t header, footer;
};

ColumnLayout columns_of(OusterProfile profile) {
  return profile == OusterProfile::legacy ? ColumnLayout{16, 4} : ColumnLayout{12, 0};
}

std::uint64_t get(Bytes p, std::size_t at, std::size_t bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < bytes; ++i) value |= static_cast<std::uint64_t>(p[at + i]) << (8 * i);
  return value;
}

double get_float(Bytes p, std::size_t at) { return std::bit_cast<float>(static_cast<std::uint32_t>(get(p, at, 4))); }

// Whether the second return of a pixel is the stronger one. Without a signal the reflectivity, which the sensor
// corrects for the distance, tells.
bool second_is_stronger(const PixelLayout& layout, Bytes pixel) {
  const auto strength = [&](std::size_t echo) {
    if (layout.signal_at[echo] > 0) return static_cast<double>(get(pixel, layout.signal_at[echo], 2));
    const double range = static_cast<double>(get(pixel, layout.range_at[echo], layout.range_bytes) & layout.range_mask);
    return range > 0 ? pixel[layout.reflectivity_at[echo]] / (range * range) : 0;
  };
  return strength(1) > strength(0);
}

// Since the start of the sensor or since 1970. A time beyond the year 2100 is damage; differences of others fit into
// 64 bits.
std::optional<std::int64_t> get_time_ns(Bytes p, std::size_t at) {
  constexpr std::uint64_t max_time_ns = 4'102'444'800'000'000'000;
  const std::uint64_t time_ns = get(p, at, 8);
  if (time_ns > max_time_ns) return {};
  return static_cast<std::int64_t>(time_ns);
}

}  // namespace

OusterDecoder::OusterDecoder(OusterMetadata metadata) : metadata_(std::move(metadata)) {
  for (const auto& c : metadata_.model.channels)
    beams_.push_back({std::cos(c.elevation_rad), std::sin(c.elevation_rad), std::cos(c.azimuth_offset_rad),
                      std::sin(c.azimuth_offset_rad), static_cast<std::uint16_t>(c.ring)});
  beam_origin_m_ = metadata_.beam_origin_up_m == 0
                       ? metadata_.beam_origin_forward_m
                       : std::hypot(metadata_.beam_origin_forward_m, metadata_.beam_origin_up_m);
}

std::size_t OusterDecoder::lidar_packet_bytes() const {
  const auto column = columns_of(metadata_.profile);
  const std::size_t columns = static_cast<std::size_t>(metadata_.columns_per_packet) *
                              (column.header + beams_.size() * layout_of(metadata_.profile).bytes + column.footer);
  return metadata_.profile == OusterProfile::legacy ? columns : packet_header + columns + packet_footer;
}

OusterDecoder::Column OusterDecoder::column(Bytes packet, int index) const {
  const bool legacy = metadata_.profile == OusterProfile::legacy;
  const auto layout = columns_of(metadata_.profile);
  const std::size_t pixels = beams_.size() * layout_of(metadata_.profile).bytes;
  const std::size_t size = layout.header + pixels + layout.footer;
  const std::size_t at = (legacy ? 0 : packet_header) + static_cast<std::size_t>(index) * size;
  const std::uint64_t status = legacy ? get(packet, at + layout.header + pixels, 4) : get(packet, at + 10, 2);
  const auto time_ns = get_time_ns(packet, at);
  return {packet.subspan(at + layout.header, pixels), time_ns.value_or(0),
          static_cast<std::uint16_t>(get(packet, at + 8, 2)),
          static_cast<std::uint16_t>(legacy ? get(packet, at + 10, 2) : get(packet, 2, 2)),
          (status & 1) != 0 && time_ns};
}

std::optional<OusterPacketHead> OusterDecoder::head(Bytes packet) const {
  if (packet.size() != lidar_packet_bytes()) return {};
  OusterPacketHead head;
  head.frame_id = column(packet, 0).frame_id;
  if (metadata_.profile != OusterProfile::legacy) head.serial_number = get(packet, 7, 5);
  for (int i = 0; i < metadata_.columns_per_packet; ++i) {
    const auto c = column(packet, i);
    if (!c.valid || c.id >= metadata_.columns_per_frame) continue;
    if (head.valid_columns++ == 0) head.first_time_ns = head.last_time_ns = c.time_ns;
    head.first_time_ns = std::min(head.first_time_ns, c.time_ns);
    head.last_time_ns = std::max(head.last_time_ns, c.time_ns);
  }
  return head;
}

Eigen::Vector3f OusterDecoder::position(const Beam& beam, const Encoder& encoder, double range_m) const {
  const auto [c, s] = encoder;
  const double along = (range_m - beam_origin_m_) * beam.cos_elevation;
  const Eigen::Vector3d p_lidar(
      along * (c * beam.cos_azimuth + s * beam.sin_azimuth) + metadata_.beam_origin_forward_m * c,
      along * (s * beam.cos_azimuth - c * beam.sin_azimuth) + metadata_.beam_origin_forward_m * s,
      (range_m - beam_origin_m_) * beam.sin_elevation + metadata_.beam_origin_up_m);
  return (metadata_.T_sensor_lidar * p_lidar).cast<float>();
}

void OusterDecoder::decode(Bytes packet, std::vector<OusterReturn>& out) const {
  if (packet.size() != lidar_packet_bytes()) return;
  const auto& layout = layout_of(metadata_.profile);
  for (int i = 0; i < metadata_.columns_per_packet; ++i) {
    const auto c = column(packet, i);
    if (!c.valid || c.id >= metadata_.columns_per_frame) continue;
    // The encoder counts with the rotor, clockwise seen from above, from the lidar's x axis, which points backwards.
    const double encoder_rad = 2 * std::numbers::pi * (1 - static_cast<double>(c.id) / metadata_.columns_per_frame);
    const Encoder encoder{std::cos(encoder_rad), std::sin(encoder_rad)};
    for (std::size_t b = 0; b < beams_.size(); ++b) {
      const Bytes pixel = c.pixels.subspan(b * layout.bytes, layout.bytes);
      const bool turned = layout.returns == 2 && !metadata_.strongest_first && second_is_stronger(layout, pixel);
      for (int r = 0; r < layout.returns; ++r) {
        const auto echo = static_cast<std::size_t>(turned ? 1 - r : r);
        const auto counts =
            static_cast<std::uint32_t>(get(pixel, layout.range_at[echo], layout.range_bytes)) & layout.range_mask;
        if (counts == 0) continue;
        const double range_m = counts * layout.metres_per_count;
        out.push_back({position(beams_[b], encoder, range_m), static_cast<float>(range_m), c.time_ns, c.id,
                       beams_[b].ring, pixel[layout.reflectivity_at[echo]], static_cast<std::uint8_t>(r + 1)});
      }
    }
  }
}

std::optional<InertialSample> OusterDecoder::inertial_sample(Bytes packet) {
  if (packet.size() != imu_packet_bytes) return {};
  constexpr std::size_t gyroscope_time = 16, accelerometer = 24, gyroscope = 36;
  const auto time_ns = get_time_ns(packet, gyroscope_time);
  if (!time_ns) return {};
  InertialSample sample;
  sample.time_s = 1e-9 * static_cast<double>(*time_ns);
  for (int axis = 0; axis < 3; ++axis) {
    const auto at = 4 * static_cast<std::size_t>(axis);
    sample.specific_force_m_s2[axis] = standard_gravity * get_float(packet, accelerometer + at);
    sample.angular_rate_rad_s[axis] = radians(get_float(packet, gyroscope + at));
  }
  if (!sample.specific_force_m_s2.allFinite() || !sample.angular_rate_rad_s.allFinite()) return {};
  return sample;
}

}  // namespace bole::sensor
