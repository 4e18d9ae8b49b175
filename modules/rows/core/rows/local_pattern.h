// What the planting looks like about every plant: direction of the row, spacing along and across it.
#pragma once

#include <vector>

#include "base/run.h"
#include "rows/core/rows/plant_grid.h"
#include "rows/core/rows/row_options.h"

namespace bole::rows {

struct LocalPattern {
  double angle_rad = 0;        // of the row, in (-pi/2, pi/2]
  double confidence = 0;       // share of the votes that agree, 0 to 1
  double plant_spacing_m = 0;  // along the row
  double row_spacing_m = 0;    // across; infinite where no neighbouring row is seen
};

// About each plant, vectors between near plants vote for a direction, short ones more; the peak over the plants around
// is the direction of the row there. Spacings are medians over the same plants. Needs two points or more.
std::vector<LocalPattern> local_patterns(const Points2& plants, const PlantGrid& grid, const RowOptions& options,
                                         const Run& run);

}  // namespace bole::rows
