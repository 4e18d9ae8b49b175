// From the plants of a frame to their centres (SPEC B5).
#pragma once

#include "base/report.h"
#include "cloud/point_cloud.h"
#include "cloud/table.h"
#include "rows/core/frame/frame_options.h"

namespace bole::rows {

struct FoundTrunks {
  Table stems;        // tree_id, x_m, y_m, layers, points, diameter_cm (NaN for centre = mean)
  PointCloud points;  // those of the trunks, with the column `plant`; where a face was fitted, those near it
};

// Each plant is cut into layers; layers whose extents along x and y are within d_x and d_y are trunk
// ("scan-area-adaptive", eq. 7), and the mean of the trunk points in plan is the centre. Plants with too few trunk
// layers are named in the report. `dense`: the same frame before it was thinned, levelled, the sensor at its origin;
// needed for centre = face. Throws Error{bad_input} where it is needed and null.
FoundTrunks trunk_centres(const PointCloud& plants, const PointCloud* dense, const TrunkOptions& options,
                          Report& report);

}  // namespace bole::rows
