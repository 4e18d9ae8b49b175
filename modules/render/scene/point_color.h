// What points of a 3-D view are coloured by.
#pragma once

#include "cloud/point_cloud.h"
#include "render/draw/axes.h"

namespace bole {

enum class PointColor { height, intensity, tree, plain };

// The values that points are coloured by, and the range that the map covers (2nd to 98th percentile, as legends show it).
struct PointColoring {
  PointColor by = PointColor::height;
  Interval range;
};

// Falls back to height where the cloud lacks the array.
PointColoring coloring_for(const PointCloud& cloud, const std::vector<std::uint32_t>& indices, PointColor by);

}  // namespace bole
