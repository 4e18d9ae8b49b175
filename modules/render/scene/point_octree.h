// Levels of detail of a cloud: a view of any size is drawn from as many points as the frame has time for.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/run.h"
#include "cloud/point_cloud.h"
#include "render/scene/point_nodes.h"

namespace bole::render {

// An octree in which every point lies in exactly one node: a node holds one point of each of its 64^3 cells that none
// of its ancestors took already, so nodes down to some depth together are an even sample of the cloud whose spacing
// halves with each level (M. Schuetz, Potree, thesis, Vienna 2016). Where few points are left a node takes them all.
// Built without sampling: along the Morton curve the level of a point follows from the leading bits that it shares with
// the one before. 4 bytes per point.
class PointOctree {
 public:
  struct Node {
    Eigen::Vector3f centre = Eigen::Vector3f::Zero();  // of the cube, offset from the cloud's origin
    float half_m = 0;                                  // half its side
    std::uint32_t begin = 0, end = 0;                  // of its points in order()
    std::uint32_t first_child = 0;
    std::uint8_t children = 0, level = 0;
    std::uint32_t size() const { return end - begin; }
    double spacing_m() const { return 2.0 * static_cast<double>(half_m) / cells_per_side; }
  };
  static constexpr int cells_per_side = 64;

  // Points that are not finite are left out. The same for the same cloud at any number of threads. Throws
  // Error{cancelled}, Error{bad_input} beyond 2^32 - 1 points.
  explicit PointOctree(const PointCloud& cloud, const Run& run = {});

  // An even share of about `points` of a cloud, at once: to be shown while the octree is built. All nodes are as large
  // as the cloud, each a share of its own, so that budgets hold; far more than `points` are never touched.
  static PointOctree sample(const PointCloud& cloud, std::size_t points);

  const std::vector<Node>& nodes() const { return nodes_; }  // the root first, level by level; empty without points
  std::size_t size() const { return order_.size(); }
  std::span<const std::uint32_t> points(const Node& node) const {
    return std::span(order_).subspan(node.begin, node.size());
  }

  // Nodes to draw, the most important first, with at most `budget` points together: always the largest on the screen
  // next; those outside of the view and those finer than `min_px` between points are left out.
  std::vector<std::uint32_t> visible(const OctreeView& view, std::size_t budget, double min_px) const;

  // Points within a box in coordinates relative to the cloud's origin, as indices of the cloud in no special order.
  std::vector<std::uint32_t> in_box(const Eigen::Vector3f& lo, const Eigen::Vector3f& hi) const;

 private:
  PointOctree() = default;
  std::shared_ptr<const PointCloud::Positions> positions_;
  std::vector<std::uint32_t> order_;
  std::vector<Node> nodes_;
};

// The octree of a cloud in memory as a source of nodes; null where either is.
std::shared_ptr<PointNodes> nodes_in_memory(std::shared_ptr<const PointCloud> cloud,
                                            std::shared_ptr<const PointOctree> octree);

}  // namespace bole::render
