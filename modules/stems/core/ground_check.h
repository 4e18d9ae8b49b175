// Whether the terrain under each stem can be the ground that it stands on.
#pragma once

#include <vector>

#include "base/report.h"
#include "base/run.h"
#include "stems/core/fit/fit_stem.h"

namespace bole::stems {

// Looks at the points around the foot of each stem (height_above_ground, classification where there is one, the fact
// `terrain`) and lowers the quality of a stem that goes on below the terrain, begins in the air, or stands where no
// ground was seen; each with a reason in words. What concerns any stem is a finding of the report.
void check_ground(std::vector<Stem>& stems, const PointCloud& points, double breast_height_m, const Run& run,
                  Report& report);

}  // namespace bole::stems
