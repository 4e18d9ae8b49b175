// Which tree every point near a stem belongs to, and which points are bark.
#pragma once

#include <vector>

#include "base/run.h"
#include "cloud/point_cloud.h"
#include "stems/core/fit/fit_stem.h"

namespace bole::stems {

struct PointLabels {
  std::vector<std::int32_t> tree_id;  // 0: none
  std::vector<std::uint8_t> stem;     // 1: bark
};

// A point belongs to the nearest axis within the reach of its height: near the stem below, up to 2.5 m (crown_radius
// where that is less) from search_top upwards; grow_crowns() says more of the points above. Bark lies within
// bark_tolerance of the fitted surface over the measured part of the stem.
PointLabels assign_points(const std::vector<Stem>& stems, const PointCloud& points, const MeasureOptions& options,
                          const Run& run);

}  // namespace bole::stems
