// What points of a 3-D view are coloured by.
#pragma once

#include <array>
#include <string_view>

#include "cloud/point_cloud.h"
#include "render/draw/axes.h"

namespace bole::render {

enum class PointColor { height, intensity, tree, plain };
constexpr std::array<std::string_view, 4> choice_names(PointColor) { return {"height", "intensity", "tree", "plain"}; }

// The values that points are coloured by, and the range that the map covers (from the 2nd percentile, or 0 for heights
// above ground, to the 98th, of heights the 99.5th).
struct PointColoring {
  PointColor by = PointColor::height;
  Interval range;
};

// Falls back to height where the cloud lacks the array.
PointColoring coloring_for(const PointCloud& cloud, const std::vector<std::uint32_t>& indices, PointColor by);

}  // namespace bole::render
