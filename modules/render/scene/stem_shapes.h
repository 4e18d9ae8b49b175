// Fitted stems as solids.
#pragma once

#include <string>
#include <vector>

#include "cloud/point_cloud.h"
#include "cloud/table.h"

namespace bole::render {

// A tapered stem, from foot to top.
struct StemShape {
  std::int64_t tree_id = 0;
  std::vector<Eigen::Vector3d> axis;  // at least two points
  std::vector<double> radius_m;
  Eigen::Vector3d breast_height = Eigen::Vector3d::Zero();
  double breast_radius_m = 0;
  std::string quality;
};

// From the fitted sections where a tree has two or more that were used, else from DBH, lean and taper of the stem
// table.
std::vector<StemShape> stem_shapes(const Table& stems, const Table* sections);

// Takes away the indices of points on or in a fitted stem, so that the stem itself is seen in their place.
void drop_points_on_stems(const PointCloud& cloud, const std::vector<StemShape>& stems, double margin_m,
                          std::vector<std::uint32_t>& indices);

}  // namespace bole::render
