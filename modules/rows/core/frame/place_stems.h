// Plant centres in navigation axes.
#pragma once

#include "cloud/table.h"
#include "rows/core/frame/frame_options.h"

namespace bole::rows {

// Centres moved from frame axes to navigation axes (x east, y north): turned by yaw, then shifted (SPEC B, eq. 4).
// `pose`, where it is given, takes the place of the options: one row of x_m, y_m, yaw_deg; its facts axes and crs go
// with the stems, and the standard error of the yaw as the fact yaw_se_deg, which the directions of rows share. Throws
// Error{bad_input} where both are given.
Table place_stems(const Table& stems, const PlaceOptions& options, const Table* pose = nullptr);

}  // namespace bole::rows
