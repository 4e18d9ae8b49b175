// An even sample of a cloud within a box, as offsets from an origin that two clouds share.
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "base/run.h"
#include "cloud/point_cloud.h"

namespace bole::alignment {

using Box = Eigen::AlignedBox3d;

Box box_of(const PointCloud& cloud);  // around the points that are finite; empty without any
Box grown(const Box& box, double by_m);

// Offsets of the finite points in `box`, float32 metres from `origin`.
std::vector<Eigen::Vector3f> offsets_in(const PointCloud& cloud, const Box& box, const Eigen::Vector3d& origin);

struct ThinnedPoints {
  std::vector<Eigen::Vector3f> points;
  double cell_m = 0;
};
// The first point of each cube of `cell_m`, of larger cubes where more than `max_points` would be left.
ThinnedPoints thinned(std::vector<Eigen::Vector3f> points, double cell_m, std::size_t max_points, const Run& run);

}  // namespace bole::alignment
