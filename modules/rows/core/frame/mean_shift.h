// Points of a frame to plants.
#pragma once

#include "base/run.h"
#include "cloud/point_cloud.h"
#include "rows/core/frame/frame_options.h"

namespace bole::rows {

// Name of the int32 column that numbers the plant of each point from 1; 0: none.
inline constexpr const char* plant_column = "plant";

// Mean shift in plan with a flat kernel (SPEC B5, eq. 6): every point climbs to the mean of its neighbourhood until it
// stays; points that end within half a bandwidth of one another are a plant. Plants are numbered from west to east.
PointCloud mean_shift(const PointCloud& frame, const MeanShiftOptions& options, const Run& run);

}  // namespace bole::rows
