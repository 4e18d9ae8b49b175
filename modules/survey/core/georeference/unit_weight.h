// How large residuals are beside the standard deviations they were weighted by.
#pragma once

#include <optional>

namespace bole::survey {

// Redundancies from which residuals give a standard deviation of their own.
inline constexpr int min_own_freedom = 3;

struct UnitWeight {
  double factor = 1;    // by which standard errors grow
  bool failed = false;  // stated standard deviations that the residuals contradict
};

// Stated standard deviations hold unless the sum of squares is beyond 99.9 % of chance. Assumed ones give way to the
// residuals where these have enough redundancy: then a 95 % interval is that of Student's t, and the factor contains
// the difference to 1.96.
UnitWeight unit_weight(double chi2, int redundancy, bool stated);

// The factor where nothing but the residuals tells the size of the errors, for one redundancy and more: the 95 %
// interval is Student's t with as many degrees of freedom, 12.7 times as wide as the residuals say for one. It is right
// whatever the size of the errors, and wide, because one residual hardly tells it.
double residual_factor(double chi2, int redundancy);

// The standard deviation of a file's row, else that of the option, else the usual one.
double or_usual(double stated, const std::optional<double>& option, double usual);

}  // namespace bole::survey
