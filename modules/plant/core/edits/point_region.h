// Which points a person means: a ball, a box, or what lies behind an outline that was drawn over a view.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "cloud/point_cloud.h"

namespace bole::plant {

// Metres in the axes of the points.
struct PointRegion {
  enum class Kind { ball, box, outline };

  Kind kind = Kind::ball;
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  // ball
  double radius = 0;
  Eigen::Vector3d min = Eigen::Vector3d::Zero(), max = Eigen::Vector3d::Zero();  // box
  // Corners of a closed outline, roughly in one plane. Points belong to it that are seen within it from `eye`, at any
  // distance before the eye; without an eye, those that lie within it along the normal of the plane.
  std::vector<Eigen::Vector3d> outline;
  std::optional<Eigen::Vector3d> eye;
};

// Indices of the points within, ascending. An outline whose corners lie on one line holds no point.
std::vector<std::size_t> points_in(const PointRegion& region, const PointCloud& cloud);

}  // namespace bole::plant
