// Units that options, arrays and report values are given in. Inside the code lengths are metres and angles radians;
// other units appear only at the edges, and then the name or the table says so.
#pragma once

#include <string_view>

namespace bole {
inline namespace base {

enum class Unit {
  none,
  metre,
  centimetre,
  millimetre,
  square_metre,
  cubic_metre,
  radian,
  degree,
  second,
  millisecond,
  hertz,
  metre_per_second,
  per_hectare,
  square_metre_per_hectare,
  percent,
  pixel,
  dot_per_inch,
  mebibyte
};

// The symbol printed after a number ("m", "deg", ...); empty for Unit::none.
std::string_view unit_symbol(Unit unit);

}  // namespace base
}  // namespace bole
