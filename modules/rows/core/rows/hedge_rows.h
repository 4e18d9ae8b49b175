// Rows whose canopy hides the trunks: vines, fruit walls, hedges.
#pragma once

#include <optional>

#include "base/option.h"
#include "base/report.h"
#include "base/run.h"
#include "cloud/point_cloud.h"
#include "cloud/table.h"

namespace bole::rows {

struct HedgeOptions {
  std::optional<double> direction_deg;  // left open: the direction with the sharpest profile
  double min_row_spacing = 1.5;
  double width = 1.2;
  double step = 0.5;
  int min_points = 5;
  double min_share = 0.15;
};

const OptionTable& option_table(const HedgeOptions*);

// `canopy`: points of hedges without the ground, x and y in metres. Rows are the peaks of the points' profile across
// their direction (given, or the one whose profile is sharpest); along each, pieces of `step` give a point each: the
// median across of what lies within half a `width` of the row's course so far, so that curved rows are followed. A
// piece with too few points is a gap. Table row_id (from left to right, looking along the direction), x_m, y_m, points.
// Throws Error{bad_input} for a cloud without points and for points further apart than 10 km.
Table hedge_rows(const PointCloud& canopy, const HedgeOptions& options, const Run& run, Report& report);

}  // namespace bole::rows
