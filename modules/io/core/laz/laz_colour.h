// Colours: a mask of the changed bytes, then each of them as a correction of a prediction from the bytes before it.
#pragma once

#include <array>
#include <cstdint>

#include "io/core/laz/laz_arithmetic.h"
#include "io/core/laz/laz_arithmetic_encoder.h"

namespace bole::io::laz {

using Rgb = std::array<std::uint16_t, 3>;

class ColourCoder {
 public:
  Rgb next(ArithmeticDecoder& in, const Rgb& last);
  void write(ArithmeticEncoder& out, const Rgb& last, const Rgb& colour);

 private:
  SymbolModel changed_{128};
  std::array<SymbolModel, 6> corrections_{SymbolModel(256), SymbolModel(256), SymbolModel(256),
                                          SymbolModel(256), SymbolModel(256), SymbolModel(256)};
};

}  // namespace bole::io::laz
