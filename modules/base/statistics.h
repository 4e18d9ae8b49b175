// Numbers of statistics that several modules ask for.
#pragma once

#include <span>
#include <vector>

namespace bole {
inline namespace base {

// Half the width of a 95 % interval in standard deviations of a normal distribution.
inline constexpr double z_95 = 1.959964;

// The middle value, of an even number the mean of the two in the middle; NaN without any. Values must be numbers.
double median(std::vector<double> values);

// The middle value, of an even number the larger of the two in the middle: always one of the values. NaN without any.
// Reorders `values`.
double upper_median(std::span<double> values);
inline double upper_median(std::vector<double>&& values) { return upper_median(std::span<double>(values)); }

// The 97.5 % quantile of Student's t distribution, half the width of a 95 % interval in standard deviations: 12.71 for
// one degree of freedom, 1.96 for many. NaN unless `freedom` is above zero.
double student_975(double freedom);

}  // namespace base
}  // namespace bole
