// Means over stems of what they all share.
#pragma once

#include <vector>

namespace bole::stems {

// What one stem says of a value; `doubt` is a standard deviation that all stems have in common.
struct SharedEvidence {
  double value = 0, sd = 0, doubt = 0;
};

struct SharedMean {
  double mean = 0, sd = 0;
};

// Random-effects mean of bounded influence: stems differ by `between` beyond their own sd. `shared` is what no number
// of stems averages out (standard deviation), `weak` that of a prior around zero which decides where hardly any stem
// speaks.
SharedMean bounded_mean(const std::vector<SharedEvidence>& stems, double between, double shared, double weak);

// The mean and spread of a value under a normal likelihood and a Student prior around zero of three degrees of freedom
// and scale `expected`, by quadrature: the mode would leap between zero and the evidence. Small values count little,
// those of many times `expected` nearly in full.
SharedMean drawn_to_zero(const SharedMean& likelihood, double expected);

}  // namespace bole::stems
