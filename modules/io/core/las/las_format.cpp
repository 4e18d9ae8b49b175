#include "io/core/las/las_format.h"

#include <array>

namespace bole::io::las {

const PointLayout& point_layout(int format) {
  static constexpr std::array<PointLayout, max_point_format + 1> layouts{{
      {20, false, -1, -1, -1},
      {28, false, 20, -1, -1},
      {26, false, -1, 20, -1},
      {34, false, 20, 28, -1},
      {57, false, 20, -1, -1},  // 29 bytes of waveform description at the end
      {63, false, 20, 28, -1},  // likewise
      {30, true, 22, -1, -1},
      {36, true, 22, 30, -1},
      {38, true, 22, 30, 36},
      {59, true, 22, -1, -1},  // likewise
      {67, true, 22, 30, 36},  // likewise
  }};
  return layouts[static_cast<std::size_t>(format)];
}

}  // namespace bole::io::las
