// Numbers into the bytes of a packet.
#pragma once

#include <cstdint>
#include <span>

namespace bole::sensor {

// The lowest `bytes` bytes of a value, the lowest first. The place must lie within the packet.
inline void put_little(std::span<std::uint8_t> packet, std::size_t at, std::uint64_t value, std::size_t bytes) {
  for (std::size_t i = 0; i < bytes; ++i) packet[at + i] = static_cast<std::uint8_t>(value >> (8 * i) & 0xFF);
}

}  // namespace bole::sensor
