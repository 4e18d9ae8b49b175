// Simple views of the ground, for levelling and for the height of the origin. (Terrain models are the affair of
// `ground`.)
#pragma once

#include <Eigen/Core>
#include <optional>

#include "base/run.h"
#include "cloud/point_cloud.h"

namespace bole::survey {

struct GroundPlane {
  bool valid = false;
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  // upwards, in the cloud's axes
};

// Robust plane (Tukey) through the lowest points of 1 m cells of the densest 30 m of the cloud. Not valid with fewer
// than ten cells.
GroundPlane lowest_plane(const PointCloud& cloud, const Run& run);

// Height of the ground at a place, in levelled axes: z of T_level_map * p. Points within `radius_m` of `place`
// (levelled x, y) are looked at; a robust plane through the lowest points of 0.2 m cells is moved to the densest layer
// near it. Empty when there are too few points.
std::optional<double> ground_height_at(const PointCloud& cloud, const Eigen::Matrix3d& R_level_map,
                                       const Eigen::Vector2d& place, double radius_m, const Run& run);

}  // namespace bole::survey
