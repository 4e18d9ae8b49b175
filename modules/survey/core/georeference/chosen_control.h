// Which control points carry the place of a plot, and which do not fit.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/report.h"
#include "geo/core/projected_crs.h"
#include "survey/core/georeference/blunders.h"
#include "survey/core/georeference/control_level.h"
#include "survey/core/georeference/control_points.h"
#include "survey/core/georeference/georeference_options.h"
#include "survey/core/georeference/plan_fit.h"

namespace bole::survey {

struct ChosenControl {
  // An entry per point.
  std::vector<bool> used;
  std::vector<std::string> notes;
  std::vector<LeftOut> misfits;  // NaN where a point could not be tested

  std::vector<std::size_t> rows;  // points that are used
  std::vector<PlanPair> pairs;    // of these, levelled
  ControlLevel level;
  std::optional<KnownTurn> known;  // the bearing, where it is given and does not contradict the points
  bool stated = false;             // the standard deviations of the points are given
};

// `bearing_target_rad`: as LocalPlot. What does not fit becomes a finding in `report`. Throws Error{bad_input} where
// the points carry no direction: too few, all at one place, mirrored.
ChosenControl choose_control(const std::vector<ControlPoint>& points, const geo::ProjectedCrs& crs,
                             double bearing_target_rad, const GeoreferenceOptions& options, Report& report);

}  // namespace bole::survey
