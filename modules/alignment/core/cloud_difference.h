// How far the points of a cloud lie from another one.
#pragma once

#include <vector>

#include "alignment/core/distance_histogram.h"
#include "base/run.h"
#include "cloud/point_cloud.h"

namespace bole::alignment {

struct DifferenceOptions {
  double max_m = 10;      // points of the other cloud are looked for no further than this
  bool to_plane = false;  // from the plane through the points about the nearest one: density counts less
};

struct CloudDifference {
  // Of each point of the cloud; NaN where nothing is within max_m, and where a coordinate is not finite.
  std::vector<float> distance_m;
  std::vector<float> rise_m;  // how much higher the point lies than what it was compared with; negative: lower
  std::size_t compared = 0;   // points with finite coordinates
  std::size_t beyond = 0;     // of them, those with nothing within max_m
  // Of all compared points; infinite where those beyond decide, NaN without points. rms_m is of those within.
  double median_m = 0, p95_m = 0, largest_m = 0, rms_m = 0;
  DistanceHistogram distances, rises;  // of distance_m and rise_m
};

// The two clouds are in the same axes. Throws Error{bad_input} for an empty cloud and a max_m that is not above zero,
// Error{cancelled}.
CloudDifference difference_of(const PointCloud& cloud, const PointCloud& from, const DifferenceOptions& options,
                              const Run& run);

}  // namespace bole::alignment
