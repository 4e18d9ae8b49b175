// Whether a metre in the plot is a metre on the plane of the coordinate system.
#pragma once

#include <optional>
#include <vector>

#include "base/report.h"
#include "survey/core/georeference/georeference_options.h"
#include "survey/core/georeference/plan_fit.h"

namespace bole::survey {

struct ScaleQuestion {
  std::vector<PlanPair> pairs;
  std::optional<KnownTurn> known;
  bool sd_stated = false;
  double grid = 1;     // length on the plane over length on the ground
  double reach_m = 0;  // from the centre to the farthest stem
};

struct ChosenScale {
  double value = 1;
  double doubt = 0;  // share of a distance by which it may be off, where nothing decided
};

// 1 unless asked for otherwise, or unless the residuals of `fit` (with scale 1) contradict 1 and agree with the grid's.
// What the points say is reported.
ChosenScale choose_scale(const ScaleQuestion& question, const PlanFit& fit, const std::optional<GridScale>& asked,
                         Report& report);

}  // namespace bole::survey
