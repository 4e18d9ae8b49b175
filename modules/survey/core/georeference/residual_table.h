// The control points with what the adjustment left of them.
#pragma once

#include <string>
#include <vector>

#include "cloud/table.h"
#include "survey/core/georeference/blunders.h"
#include "survey/core/georeference/control_level.h"
#include "survey/core/georeference/control_points.h"
#include "survey/core/georeference/plan_fit.h"

namespace bole::survey {

// All lists have an entry per point.
struct AdjustedPoints {
  const std::vector<ControlPoint>& points;
  const std::vector<bool>& used;
  const std::vector<std::string>& notes;
  const std::vector<LeftOut>& misfits;  // NaN where a point could not be tested
  const PlanFit& fit;
  const ControlLevel& level;
};

// The columns of Georeference::control.
Table residual_table(const AdjustedPoints& adjusted);

}  // namespace bole::survey
