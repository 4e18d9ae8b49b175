#pragma once

#include <cstddef>
#include <vector>

namespace bole::alignment {

// The smallest of the values that a share (above 0 up to 1) of `all` does not exceed; `found` are those that are known,
// the others lie above all of them. Infinite where one of those decides, NaN where `all` is 0. Reorders `found`.
double quantile(std::vector<float>& found, std::size_t all, double share);

}  // namespace bole::alignment
