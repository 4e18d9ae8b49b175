// The thin layer of points around breast height.
#pragma once

#include "base/run.h"
#include "cloud/point_cloud.h"
#include "stems/core/stem_options.h"

namespace bole::stems {

// The points whose height_above_ground lies within height -+ thickness/2, with all their arrays, in their order. The
// fact breast_height_m is the height: few points in a thin layer do not tell where it was meant to lie.
// Throws Error{bad_input} when the cloud is empty, has no heights, or no point at that height.
PointCloud breast_height_slice(const PointCloud& points, const SliceOptions& options, const Run& run);

// Breast height that a slice was cut at: its fact; of slices of other programs, the middle of their heights, to the
// centimetre (where points are sparse, to about one). Throws Error{bad_input} when it has neither.
double slice_height(const PointCloud& slice);

}  // namespace bole::stems
