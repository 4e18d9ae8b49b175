// Points of a frame that a figure draws: thinned, coloured by plant or height, with a box of round numbers around them.
#pragma once

#include <string>
#include <vector>

#include "cloud/point_cloud.h"
#include "render/rows/oblique_view.h"

namespace bole::render {

struct ViewBox {
  Eigen::Vector3d lo = Eigen::Vector3d::Constant(1e300), hi = -lo;
  void include(const Eigen::Vector3d& p);
  // To steps of 0.5 m beyond `margin_m`, so that the axes begin and end with a round number.
  void round(double margin_m);
  bool contains(const Eigen::Vector3d& p) const;
};

// Of all finite points, or of those whose column `plant` is above 0.
ViewBox box_of(const PointCloud& cloud, bool plants_only);

struct PlantCloud {
  std::vector<ViewedPoint> points;
  Eigen::Vector3d lo = Eigen::Vector3d::Zero(), hi = Eigen::Vector3d::Ones();
};

// At most about `most` points within `box`, in an order that has nothing to do with how the sensor scans.
std::vector<std::uint32_t> sampled_in(const PointCloud& cloud, const ViewBox& box, std::size_t most);

// Coloured by height, in 16 steps.
PlantCloud height_cloud(const PointCloud& cloud, const ViewBox& box, std::size_t most);
// A colour per plant; grey where the column `plant` is 0 or absent.
PlantCloud plant_cloud(const PointCloud& cloud, const ViewBox& box, std::size_t most);

// How many plants the column `plant` tells apart.
std::size_t plants_in(const PointCloud& cloud);

}  // namespace bole::render
