#include "io/core/clouds/turn_cloud.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "cloud/core/whole/whole_cloud.h"
#include "io/core/clouds/sensor_arrays.h"

namespace bole::io {
namespace {

template <class Turn>
void turn_offsets(PointCloud& cloud, const Turn& turn) {
  auto positions = cloud.positions();
  for (auto& p : positions) turn(p);
  cloud.set_positions(std::move(positions));
  if (!std::ranges::all_of(sensor_arrays, [&](const ArrayInfo& a) { return cloud.has(a); })) return;
  std::array<std::vector<float>, 3> sensor;
  for (std::size_t axis = 0; axis < 3; ++axis) sensor[axis] = cloud.values<float>(sensor_arrays[axis]);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    Eigen::Vector3f p(sensor[0][i], sensor[1][i], sensor[2][i]);
    turn(p);
    for (std::size_t axis = 0; axis < 3; ++axis) sensor[axis][i] = p[static_cast<int>(axis)];
  }
  for (std::size_t axis = 0; axis < 3; ++axis) cloud.set_column(sensor_arrays[axis], std::move(sensor[axis]));
}

void scale_ranges(PointCloud& cloud, double factor) {
  if (!cloud.has(arrays::range) || std::abs(factor - 1) < 1e-12) return;
  auto range = cloud.values<float>(arrays::range);
  for (float& r : range) r *= static_cast<float>(factor);
  cloud.set_column(arrays::range, std::move(range));
}

}  // namespace

void turn_cloud(PointCloud& cloud, const Eigen::Matrix3d& matrix) {
  if (matrix.isIdentity(0)) return;
  forget_whole(cloud.facts);
  scale_ranges(cloud, std::cbrt(std::abs(matrix.determinant())));
  turn_offsets(cloud, [&](Eigen::Vector3f& p) { p = (matrix * p.cast<double>()).cast<float>(); });
  cloud.origin = matrix * cloud.origin;
  cloud.scale = (matrix * cloud.scale).cwiseAbs();
}

void turn_cloud_about(PointCloud& cloud, const Eigen::Matrix3d& matrix, const Eigen::Vector3d& place) {
  turn_offsets(cloud, [&](Eigen::Vector3f& p) { p = (place + matrix * (p.cast<double>() - place)).cast<float>(); });
  forget_whole(cloud.facts);
  cloud.scale.setZero();  // the points have left the grid of the file
}

}  // namespace bole::io
