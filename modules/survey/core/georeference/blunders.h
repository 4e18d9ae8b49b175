// Which control point does not fit the others: every point is left out in turn (Baarda's data snooping).
#pragma once

#include <vector>

#include "survey/core/georeference/plan_fit.h"

namespace bole::survey {

// How a point lies against the adjustment of all others.
struct LeftOut {
  double distance_m = 0;  // from where the others put it
  double limit_m = 0;     // distance beyond which one good point in a thousand lies
  double others_chi2 = 0;
  int others_redundancy = 0;
  bool beyond() const { return distance_m > limit_m; }
};

// One per pair. Empty for fewer than three pairs (two with a known turn): then nothing is left to compare with. Where
// the standard deviations are stated the test is Baarda's, chi-square with 2 degrees of freedom; where they are
// assumed, their size comes from the other points (F test), with a little weight of the assumption.
std::vector<LeftOut> leave_one_out(const std::vector<PlanPair>& pairs, double scale,
                                   const std::optional<KnownTurn>& known, bool sd_stated);

// What the distances say.
struct Snooped {
  int worst = -1;         // index of the point that does not fit; -1: all fit
  std::vector<int> also;  // others that would explain the misfit as well: then none is certain
};

// The point beyond its limit by most, and those whose removal would leave a sum of squares that is as good.
Snooped snoop(const std::vector<LeftOut>& points);

// Weight of assumed standard deviations beside those of residuals, in degrees of freedom.
inline constexpr double assumed_freedom = 2;

// Quantile of the F distribution with 2 and `freedom` degrees of freedom, beyond which a share `alpha` lies (closed
// form); infinite freedom: half the quantile of chi-square with 2.
double f2_limit(double alpha, double freedom);

}  // namespace bole::survey
