// The middle of values of which it is known about where it lies.
#pragma once

#include <span>

namespace bole {
inline namespace base {

// As upper_median() (base/statistics.h); quick where the middle is near `guess`, which changes nothing else.
double upper_median_near(std::span<double> values, double guess);

}  // namespace base
}  // namespace bole
