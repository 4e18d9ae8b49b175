// The Velodyne data packet: 1206 bytes of 12 blocks with 32 records each, a time and two factory bytes. Packing and
// unpacking are in one file, so that the reader understands what the simulator writes.
// Source: Velodyne user manuals 63-9243 (VLP-16), 63-9325 (VLP-32C), 63-9113 (HDL-32E), 63-HDL64ES2, 63-9483 (VLS-128).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace bole::sensor {

inline constexpr std::size_t velodyne_packet_bytes = 1206;
inline constexpr int velodyne_blocks = 12;
inline constexpr int velodyne_records = 32;
inline constexpr std::uint16_t velodyne_upper_block = 0xEEFF;   // of every sensor
inline constexpr std::uint16_t velodyne_lower_block = 0xDDFF;   // HDL-64E, VLS-128: lasers 32 to 63
inline constexpr std::uint16_t velodyne_third_block = 0xCCFF;   // VLS-128: lasers 64 to 95
inline constexpr std::uint16_t velodyne_fourth_block = 0xBBFF;  // VLS-128: lasers 96 to 127

enum class VelodyneReturnMode : std::uint8_t { strongest = 0x37, last = 0x38, dual = 0x39 };

struct VelodyneRecord {
  std::uint16_t range_counts = 0;  // 0: no return
  std::uint8_t intensity = 0;      // 0 to 100 diffuse, 101 to 255 retro-reflective
};

struct VelodyneBlock {
  std::uint16_t flag = velodyne_upper_block;
  std::uint16_t azimuth_centideg = 0;  // of the rotor when the block's first laser fires, clockwise, 0 to 35999
  std::array<VelodyneRecord, velodyne_records> records;

  bool valid() const {
    const bool known = flag == velodyne_upper_block || flag == velodyne_lower_block || flag == velodyne_third_block ||
                       flag == velodyne_fourth_block;
    return known && azimuth_centideg < 36000;
  }
};

struct VelodynePacket {
  std::array<VelodyneBlock, velodyne_blocks> blocks;
  std::uint32_t time_us = 0;  // of the first firing, microseconds past the hour
  std::uint8_t return_mode = static_cast<std::uint8_t>(VelodyneReturnMode::strongest);
  std::uint8_t product_id = 0;

  bool is_dual() const { return return_mode == static_cast<std::uint8_t>(VelodyneReturnMode::dual); }
};

// Nothing where the length is not 1206 bytes or no block is valid.
std::optional<VelodynePacket> parse_velodyne_packet(std::span<const std::uint8_t> bytes);

std::array<std::uint8_t, velodyne_packet_bytes> pack_velodyne_packet(const VelodynePacket& packet);

}  // namespace bole::sensor
