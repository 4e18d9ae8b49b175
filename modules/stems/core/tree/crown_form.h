// Where the crowns of the trees begin and the ground that they cover.
#pragma once

#include <vector>

#include "base/report.h"
#include "base/run.h"
#include "stems/core/tree/assign_points.h"

namespace bole::stems {

// Area that points cover in the plan: that of their alpha shape (a disk of `reach_m` rolls around them), so that
// hollows in the outline are not counted. 0 for fewer than three points.
double covered_area_m2(const std::vector<Eigen::Vector2d>& points, double reach_m);

// Sets crown_base_m, the height above ground from which branches stand out on three sides at least over a metre of
// height, and crown_area_m2, the area that the points above cover. NaN where no crown is seen. Crowns are cut where
// the points of a tree end (crown_radius). A tree whose crown cannot be measured keeps NaN, and the report is warned.
void measure_crowns(std::vector<Stem>& stems, const PointCloud& points, const PointLabels& labels, const Run& run,
                    Report& report);

}  // namespace bole::stems
