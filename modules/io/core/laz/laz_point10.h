// The models of the point of formats 0 to 5, algorithm version 2, for its decoder and its encoder.
#pragma once

#include <array>
#include <cstdint>

#include "io/core/las/las_format.h"
#include "io/core/laz/laz_integer.h"
#include "io/core/laz/laz_returns.h"

namespace bole::io::laz {

inline constexpr std::size_t point10_size = 20;

inline std::array<SymbolModel, 256> models_by_byte() {
  std::array<SymbolModel, 256> models;
  models.fill(SymbolModel(256));
  return models;
}

struct Point10Models {
  SymbolModel changed{64};
  // One for each previous value of the byte.
  std::array<SymbolModel, 256> returns = models_by_byte(), classes = models_by_byte(), user_data = models_by_byte();
  IntegerCoder source{16};
  std::array<std::uint16_t, 16> intensities{};
  std::array<RunningMedian, 16> dx, dy;
  std::array<std::int32_t, 8> heights{};
  std::array<SymbolModel, 2> scan_angle{SymbolModel(256), SymbolModel(256)};
  IntegerCoder intensity{16, 4}, x{32, 2}, y{32, 22}, z{32, 20};
};

namespace point10 {

// Bits of Point10Models::changed.
enum Change : unsigned {
  source_changed = 1,
  user_data_changed = 2,
  angle_changed = 4,
  class_changed = 8,
  intensity_changed = 16,
  returns_changed = 32
};

}  // namespace point10

// What the byte of the returns says of a point.
struct Point10Return {
  explicit Point10Return(std::uint8_t returns) {
    const unsigned r = returns & 7U, n = returns >> 3 & 7U;
    kind = return_map[n][r];
    level = return_level(n, r);
    single = n == 1;
    direction = returns >> 6 & 1U;
  }
  unsigned kind, level, direction;
  bool single;
};

}  // namespace bole::io::laz
