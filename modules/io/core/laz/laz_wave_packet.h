// The waveform packet of a point: 29 bytes that Bole does not use but must decode to reach the fields after them.
#pragma once

#include <array>
#include <cstdint>

#include "io/core/laz/laz_integer.h"

namespace bole::io::laz {

inline constexpr std::size_t wave_packet_size = 29;

class WavePacketDecoder {
 public:
  // Turns the bytes of the last packet into those of the next.
  void next(ArithmeticDecoder& in, std::array<std::uint8_t, wave_packet_size>& packet);

 private:
  SymbolModel index_{256};
  std::array<SymbolModel, 4> offset_kind_{SymbolModel(4), SymbolModel(4), SymbolModel(4), SymbolModel(4)};
  IntegerCoder offset_{32}, size_{32}, return_point_{32}, direction_{32, 3};
  unsigned last_kind_ = 0;
  std::int32_t last_offset_difference_ = 0;
};

}  // namespace bole::io::laz
