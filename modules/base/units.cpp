#include "base/units.h"

namespace bole {
inline namespace base {

std::string_view unit_symbol(Unit unit) {
  switch (unit) {
    case Unit::none:
      return "";
    case Unit::metre:
      return "m";
    case Unit::centimetre:
      return "cm";
    case Unit::millimetre:
      return "mm";
    case Unit::square_metre:
      return "m2";
    case Unit::cubic_metre:
      return "m3";
    case Unit::radian:
      return "rad";
    case Unit::degree:
      return "deg";
    case Unit::second:
      return "s";
    case Unit::millisecond:
      return "ms";
    case Unit::hertz:
      return "Hz";
    case Unit::metre_per_second:
      return "m/s";
    case Unit::per_hectare:
      return "1/ha";
    case Unit::square_metre_per_hectare:
      return "m2/ha";
    case Unit::percent:
      return "%";
    case Unit::pixel:
      return "px";
    case Unit::dot_per_inch:
      return "dpi";
    case Unit::mebibyte:
      return "MiB";
  }
  return "";
}

}  // namespace base
}  // namespace bole
