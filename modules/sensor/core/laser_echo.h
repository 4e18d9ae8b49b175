// What one laser measures with one pulse.
#pragma once

#include <cstdint>

namespace bole::sensor {

struct LaserEcho {
  float range_m = 0;  // 0: none
  std::uint8_t intensity = 0;
};

}  // namespace bole::sensor
