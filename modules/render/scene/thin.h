// Chooses the points that are worth drawing.
#pragma once

#include <cstdint>
#include <vector>

#include "base/run.h"
#include "cloud/point_cloud.h"

namespace bole::render {

// A horizontal window in the coordinates of the cloud, metres.
struct Window {
  Eigen::Vector2d lo = Eigen::Vector2d::Constant(-1e300);
  Eigen::Vector2d hi = Eigen::Vector2d::Constant(1e300);
  bool contains(const Eigen::Vector3d& p) const {
    return p.x() >= lo.x() && p.x() <= hi.x() && p.y() >= lo.y() && p.y() <= hi.y();
  }
};

// The middle `share` of the points in x and y, by order statistics of a sample: a few stray points do not count.
Window middle_window(const PointCloud& cloud, double share = 0.98);

// Indices, ascending, of at most about `budget` finite points within the window: one per voxel of the smallest size
// that keeps the budget, so that places that were scanned often are not drawn denser than others. Of a cloud that is
// much larger than the budget only every n-th point is looked at. Deterministic. Throws Error{cancelled}.
std::vector<std::uint32_t> thin_for_drawing(const PointCloud& cloud, const Window& window, std::size_t budget,
                                            const Run& run = {});

}  // namespace bole::render
