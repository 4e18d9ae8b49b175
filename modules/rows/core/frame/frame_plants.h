// From the points of a frame to the centres of plants (SPEC B5).
#pragma once

#include "base/report.h"
#include "base/run.h"
#include "cloud/point_cloud.h"
#include "cloud/table.h"
#include "rows/core/frame/frame_options.h"

namespace bole::rows {

// Name of the int32 column that numbers the plant of each point from 1; 0: none.
inline constexpr const char* plant_column = "plant";

// Mean shift in plan with a flat kernel (eq. 6): every point climbs to the mean of its neighbourhood until it stays;
// points that end within half a bandwidth of one another are a plant. Plants are numbered from west to east.
PointCloud mean_shift(const PointCloud& frame, const MeanShiftOptions& options, const Run& run);

// Centres: each plant is cut into layers; layers whose extents along x and y are within d_x and d_y are trunk
// ("scan-area-adaptive", eq. 7), and the mean of the trunk points in plan is the centre. Table x_m, y_m, tree_id,
// layers, points, diameter_cm (NaN for centre = mean). Plants with too few trunk layers are named in the report.
// `dense`: the same frame before it was thinned, levelled, the sensor at its origin; needed for centre = face.
Table trunk_centres(const PointCloud& plants, const PointCloud* dense, const TrunkOptions& options, Report& report);

// Centres moved from frame axes to navigation axes (x east, y north): turned by yaw, then shifted (eq. 4). `pose`,
// where it is given, takes the place of the options: one row of x_m, y_m, yaw_deg; its facts axes and crs go with the
// stems, and the standard error of the yaw as the fact yaw_se_deg, which the directions of rows share. Throws
// Error{bad_input} where both are given.
Table place_stems(const Table& stems, const PlaceOptions& options, const Table* pose = nullptr);

}  // namespace bole::rows
