// Student's t distribution: how far a mean of few measurements may lie off.
#pragma once

namespace bole {

// The 97.5 % quantile, half the width of a 95 % interval in standard deviations: 12.71 for one degree of freedom, 1.96
// for many. NaN unless `freedom` is above zero.
double student_975(double freedom);

}  // namespace bole
