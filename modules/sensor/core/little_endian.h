// Numbers of the packets of several makers, lowest byte first.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace bole::sensor {

inline std::uint16_t little16(std::span<const std::uint8_t> p, std::size_t at) {
  return static_cast<std::uint16_t>(p[at] | p[at + 1] << 8);
}

}  // namespace bole::sensor
