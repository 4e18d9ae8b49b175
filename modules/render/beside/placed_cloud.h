// A cloud that is shown elsewhere than its coordinates say: moved, turned, tilted and scaled.
#pragma once

#include <memory>

#include "cloud/point_cloud.h"
#include "render/scene/point_nodes.h"

namespace bole::render {

// Metres. A point p comes to lie at pivot + scale R (p - pivot) + shift, R = Rz(turn) Ry(tilt_y) Rx(tilt_x), each angle
// counter-clockwise as its axis points at who looks: a turn is one seen from above.
struct CloudPlace {
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  double turn_rad = 0, tilt_x_rad = 0, tilt_y_rad = 0;
  double scale = 1;
  Eigen::Vector3d pivot = Eigen::Vector3d::Zero();  // in the cloud's own coordinates

  bool only_shifts() const { return turn_rad == 0 && tilt_x_rad == 0 && tilt_y_rad == 0 && scale == 1; }
  bool is_upright() const { return tilt_x_rad == 0 && tilt_y_rad == 0; }  // what was vertical still is
  bool moves_nothing() const { return only_shifts() && shift.isZero(0); }
  bool operator==(const CloudPlace& other) const = default;

  Eigen::Matrix3d turn() const;    // R
  Eigen::Matrix3d linear() const;  // scale R
  Eigen::Vector3d of(const Eigen::Vector3d& p) const;
  Eigen::Vector3d back(const Eigen::Vector3d& world) const;  // where a place lies in the cloud's own axes
};

// Where nothing is turned or scaled the positions are shared. Moved points have no grid of the file any more
// (PointCloud::scale).
PointCloud placed_cloud(const PointCloud& cloud, const CloudPlace& place);

// The same of a source of nodes: each is moved when it is asked for. Null of null.
std::shared_ptr<PointNodes> placed_nodes(std::shared_ptr<PointNodes> nodes, const CloudPlace& place);

}  // namespace bole::render
