#include "survey/core/georeference/unit_weight.h"

#include <cmath>

#include "base/statistics.h"
#include "survey/core/georeference/blunders.h"

namespace bole::survey {
namespace {

// Of the sum of squares in chance, one in a thousand (Wilson and Hilferty 1931).
double chi2_limit(int freedom) {
  constexpr double normal_999 = 3.0902;
  const double f = freedom, part = 2 / (9 * f);
  return f * std::pow(1 - part + normal_999 * std::sqrt(part), 3);
}

}  // namespace

UnitWeight unit_weight(double chi2, int redundancy, bool stated) {
  if (redundancy <= 0) return {};
  if (stated) {
    if (chi2 <= chi2_limit(redundancy)) return {};
    return {std::sqrt(chi2 / redundancy), true};
  }
  if (redundancy >= min_own_freedom) return {residual_factor(chi2, redundancy), false};
  const double freedom = assumed_freedom + redundancy;
  return {std::sqrt((assumed_freedom + chi2) / freedom) * student_975(freedom) / z_95, false};
}

double residual_factor(double chi2, int redundancy) {
  return std::sqrt(chi2 / redundancy) * student_975(redundancy) / z_95;
}

double or_usual(double stated, const std::optional<double>& option, double usual) {
  return std::isfinite(stated) ? stated : option.value_or(usual);
}

}  // namespace bole::survey
