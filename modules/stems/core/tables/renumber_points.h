// Tree ids of points in other numbers.
#pragma once

#include <cstdint>
#include <map>

#include "base/run.h"
#include "cloud/point_cloud.h"

namespace bole::stems {

// `points` with the column tree_id in new numbers. Points of trees that are not in the list belong to no tree (0), and
// are no bark where there is a column `stem`.
PointCloud renumber_points(const PointCloud& points, const std::map<std::int32_t, std::int32_t>& number,
                           const Run& run);

}  // namespace bole::stems
