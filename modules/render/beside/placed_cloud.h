// A cloud that is shown elsewhere than its coordinates say: moved, and turned about the vertical.
#pragma once

#include <memory>

#include "cloud/point_cloud.h"
#include "render/scene/point_nodes.h"

namespace bole::render {

// Metres. A point p comes to lie at pivot + R (p - pivot) + shift, where R turns counter-clockwise seen from above.
struct CloudPlace {
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  double turn_rad = 0;
  Eigen::Vector2d pivot = Eigen::Vector2d::Zero();  // in the plan of the cloud's own coordinates

  bool moves_nothing() const { return turn_rad == 0 && shift.isZero(0); }
  bool operator==(const CloudPlace& other) const {
    return shift == other.shift && turn_rad == other.turn_rad && pivot == other.pivot;
  }

  Eigen::Matrix3d turn() const;
  Eigen::Vector3d of(const Eigen::Vector3d& p) const;
  Eigen::Vector2d back(const Eigen::Vector2d& plan) const;  // where a place in the plan lies in the cloud's own axes
};

// Where nothing is turned the positions are shared. Moved points have no grid of the file any more (PointCloud::scale).
PointCloud placed_cloud(const PointCloud& cloud, const CloudPlace& place);

// The same of a source of nodes: each is moved when it is asked for. Null of null.
std::shared_ptr<PointNodes> placed_nodes(std::shared_ptr<PointNodes> nodes, const CloudPlace& place);

}  // namespace bole::render
