// A median with a word for nothing.
#pragma once

#include <vector>

#include "base/statistics.h"

namespace bole::rows {

// One of the values (upper_median), or `if_empty`.
inline double median_or(std::vector<double> values, double if_empty) {
  return values.empty() ? if_empty : upper_median(values);
}

}  // namespace bole::rows
