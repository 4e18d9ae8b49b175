// The thin layer of points around breast height.
#pragma once

#include "base/run.h"
#include "cloud/point_cloud.h"
#include "stems/core/stem_options.h"

namespace bole::stems {

// Few points in a thin layer do not tell where it was meant to lie.
inline constexpr ArrayInfo slice_height{"slice_height", ArrayType::float32, Unit::metre,
                                        "Height above ground that the slice was cut at, the same for all its points."};

// The points whose height_above_ground lies within height -+ thickness/2, with all their arrays and slice_height, in
// their order.
// Throws Error{bad_input} when the cloud is empty, has no heights, or no point at that height.
PointCloud breast_height_slice(const PointCloud& points, const SliceOptions& options, const Run& run);

// Breast height that a slice was cut at: its slice_height; of slices without, the middle of their heights, to the
// centimetre (where points are sparse, to about one). Throws Error{bad_input} when empty.
double slice_height_m(const PointCloud& slice);

}  // namespace bole::stems
