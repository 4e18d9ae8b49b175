// Where a layer of points gets its nodes from: an octree in memory, or one on disk whose points arrive later.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <queue>
#include <utility>
#include <vector>

#include "cloud/point_cloud.h"

namespace bole::render {

// What a camera sees, for choosing what to draw.
struct OctreeView {
  Eigen::Matrix4d world_to_clip = Eigen::Matrix4d::Identity();  // takes coordinates relative to the cloud's origin
  double height_px = 1;
  Eigen::Vector3f lo{-1e30F, -1e30F, -1e30F}, hi{1e30F, 1e30F, 1e30F};  // a box outside of which nothing is wanted
};

// Points of one cloud.
struct PointSet {
  std::shared_ptr<const PointCloud> cloud;  // null: none, or not here yet
  std::vector<std::uint32_t> indices;
  Eigen::AlignedBox3d box{};  // around them, world axes; empty: not known
};

class PointNodes {
 public:
  virtual ~PointNodes() = default;

  // That the coordinates of a view are relative to.
  virtual Eigen::Vector3d origin() const = 0;
  // Nodes to draw, the most important first, with at most `budget` points together; nodes finer than `min_px` between
  // points are left out. Of those chosen, the points that are not here are fetched, in this order, and what was asked
  // for before is given up.
  virtual std::vector<std::uint32_t> choose(const OctreeView& view, std::size_t budget, double min_px) = 0;
  virtual std::size_t size_of(std::uint32_t node) const = 0;  // points
  // Without a cloud while they are on their way.
  virtual PointSet points(std::uint32_t node) const = 0;
  virtual std::shared_ptr<const PointCloud> cloud_of(std::uint32_t node) const = 0;
  // Points of prepared nodes that are kept, drawn or not.
  virtual std::size_t max_prepared() const { return 12'000'000; }
};

// A cube of an octree as a view looks at it.
struct NodeCube {
  Eigen::Vector3f centre = Eigen::Vector3f::Zero();
  float half_m = 0;      // half its side
  double spacing_m = 1;  // between its points
  std::size_t points = 0;
  bool wanted = false;  // chosen without points as well
};

// How large a cube is on the screen, pixels; negative when it is outside of the view.
double size_on_screen(const Eigen::Vector3f& centre, float half_m, const OctreeView& view);

// Always the largest on the screen next; those outside of the view, and the children of those whose points are nearer
// to one another than `min_px`, are left out. cube(node) is a NodeCube, children(node, f) calls f(child).
template <class CubeOf, class Children>
std::vector<std::uint32_t> largest_on_screen(const OctreeView& view, std::size_t budget, double min_px, CubeOf&& cube,
                                             Children&& children) {
  std::vector<std::uint32_t> chosen;
  std::priority_queue<std::pair<double, std::uint32_t>> waiting;
  const auto consider = [&](std::uint32_t i) {
    const NodeCube c = cube(i);
    if (const double px = size_on_screen(c.centre, c.half_m, view); px >= 0) waiting.emplace(px, i);
  };
  consider(0);
  for (std::size_t points = 0; !waiting.empty();) {
    const auto [px, i] = waiting.top();
    waiting.pop();
    const NodeCube c = cube(i);
    if (points + c.points > budget && (i > 0 || budget == 0)) break;  // something is drawn in any case
    points += c.points;
    if (c.points > 0 || c.wanted) chosen.push_back(i);
    if (px * c.spacing_m / (2.0 * static_cast<double>(c.half_m)) > min_px) children(i, consider);
  }
  return chosen;
}

}  // namespace bole::render
