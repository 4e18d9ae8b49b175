// The thin layer of points around breast height.
#pragma once

#include "base/run.h"
#include "cloud/point_cloud.h"
#include "stems/core/stem_options.h"

namespace bole {

// The points whose height_above_ground lies within height -+ thickness/2, with all their arrays, in their order.
// Throws Error{bad_input} when the cloud is empty, has no heights, or no point at that height.
PointCloud breast_height_slice(const PointCloud& points, const SliceOptions& options, const Run& run);

// Breast height that a slice was cut at: the middle of its heights, to the centimetre (where points are sparse, to
// about one). Throws Error{bad_input} when empty.
double slice_height_m(const PointCloud& slice);

}  // namespace bole
