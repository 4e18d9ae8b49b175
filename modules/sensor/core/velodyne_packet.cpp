#include "sensor/core/velodyne_packet.h"

#include <algorithm>

namespace bole::sensor {
namespace {

constexpr std::size_t block_bytes = 4 + 3 * velodyne_records;
constexpr std::size_t tail = velodyne_blocks * block_bytes;
static_assert(tail + 6 == velodyne_packet_bytes);

std::uint16_t get16(const std::uint8_t* p) { return static_cast<std::uint16_t>(p[0] | p[1] << 8); }

void put16(std::uint8_t* p, std::uint16_t value) {
  p[0] = static_cast<std::uint8_t>(value & 0xFF);
  p[1] = static_cast<std::uint8_t>(value >> 8);
}

}  // namespace

std::optional<VelodynePacket> parse_velodyne_packet(std::span<const std::uint8_t> bytes) {
  if (bytes.size() != velodyne_packet_bytes) return std::nullopt;
  VelodynePacket packet;
  for (std::size_t b = 0; b < packet.blocks.size(); ++b) {
    const std::uint8_t* p = bytes.data() + b * block_bytes;
    auto& block = packet.blocks[b];
    block.flag = get16(p);
    block.azimuth_centideg = get16(p + 2);
    p += 4;
    for (auto& record : block.records) {
      record = {get16(p), p[2]};
      p += 3;
    }
  }
  if (std::ranges::none_of(packet.blocks, &VelodyneBlock::valid)) return std::nullopt;
  const std::uint8_t* p = bytes.data() + tail;
  packet.time_us = static_cast<std::uint32_t>(get16(p)) | static_cast<std::uint32_t>(get16(p + 2)) << 16;
  packet.return_mode = p[4];
  packet.product_id = p[5];
  return packet;
}

std::array<std::uint8_t, velodyne_packet_bytes> pack_velodyne_packet(const VelodynePacket& packet) {
  std::array<std::uint8_t, velodyne_packet_bytes> bytes{};
  for (std::size_t b = 0; b < packet.blocks.size(); ++b) {
    std::uint8_t* p = bytes.data() + b * block_bytes;
    const auto& block = packet.blocks[b];
    put16(p, block.flag);
    put16(p + 2, block.azimuth_centideg);
    p += 4;
    for (const auto& record : block.records) {
      put16(p, record.range_counts);
      p[2] = record.intensity;
      p += 3;
    }
  }
  std::uint8_t* p = bytes.data() + tail;
  put16(p, static_cast<std::uint16_t>(packet.time_us & 0xFFFF));
  put16(p + 2, static_cast<std::uint16_t>(packet.time_us >> 16));
  p[4] = packet.return_mode;
  p[5] = packet.product_id;
  return bytes;
}

}  // namespace bole::sensor
