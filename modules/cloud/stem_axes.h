// The directions of stems in a cloud that is not yet level.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "base/run.h"
#include "cloud/point_cloud.h"

namespace bole {
inline namespace cloud {

struct StemAxis {
  Eigen::Vector3d direction;  // unit, upwards
  Eigen::Vector3d middle;     // relative to PointCloud::origin
  double length_m = 0;
  double residual_m = 0;  // of the layer middles about the axis, root mean square
};

// A thinned cloud: the middles of 5 cm cubes, at most about three million of them, relative to PointCloud::origin.
std::vector<Eigen::Vector3d> thinned(const PointCloud& cloud, const Run& run);

// Stems as chains of small groups of points in layers 0.4 m thick, at right angles to `up`: groups no wider than 0.8 m
// that continue each other over at least 2 m, straight to a few centimetres, and no further than `max_angle_rad` from
// `up`.
std::vector<StemAxis> find_stem_axes(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& up,
                                     double max_angle_rad, const Run& run);

}  // namespace cloud
}  // namespace bole
