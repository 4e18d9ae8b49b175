// A number that is not known: NaN in memory, an empty cell in files.
#pragma once

#include <limits>

namespace bole {
inline namespace base {

inline constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

}  // namespace base
}  // namespace bole
