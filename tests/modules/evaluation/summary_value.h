// A value of a summary of evaluations.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "cloud/table.h"

namespace bole::evaluation {

// NaN and a failure where the summary has no such measure.
inline double value(const Table& summary, const std::string& measure) {
  const auto& names = summary.texts("measure");
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] == measure) return summary.numbers("value")[i];
  ADD_FAILURE() << "no measure " << measure;
  return std::nan("");
}

}  // namespace bole::evaluation
