// The octree of a COPC file that is written: which points lie in which node.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "base/run.h"
#include "io/core/las/las_records.h"

namespace bole::io::copc {

struct OctreeNode {
  int level = 0;
  Eigen::Vector3i key = Eigen::Vector3i::Zero();  // place among the 2^level cubes of each axis
  las::PointList points;
};

struct Octree {
  std::vector<OctreeNode> nodes;     // level by level, parents before their children; none without points
  std::vector<std::uint32_t> order;  // the points of the nodes one after the other, within a node as in the cloud
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  // of the cube of the root
  double half_size = 1;
  double spacing = 0;  // of the points of the root; half of it in each level below
};

// The cube of a root, and the node in it that holds all points.
struct OctreeRoot {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(-1);
  double side = 2;
  int level = 0;
  Eigen::Vector3i key = Eigen::Vector3i::Zero();

  // The place of a point along each axis of the cube, of which 2^28 lie side by side. For points within it only.
  static constexpr unsigned place_bits = 28, grid_bits = 7;  // a node has a grid of 128 cells across
  std::array<std::uint32_t, 3> place(const las::Grid& grid, const std::array<std::int32_t, 3>& steps) const {
    std::array<std::uint32_t, 3> out{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      const double share = (grid.offset[axis] + grid.scale[axis] * steps[k] - low[axis]) / side;
      out[k] = static_cast<std::uint32_t>(share * (1U << place_bits));
    }
    return out;
  }
  Eigen::Vector3d centre() const { return low.array() + side / 2; }
  double spacing() const;  // of the points of the root
  // The lowest level that is of use: finer cells than the steps of the file do not tell points apart.
  int deepest(double step) const;
};

// The cube around points between the least and the greatest steps of a grid, a step wider than they are.
OctreeRoot root_around(const las::Grid& grid, const std::array<std::int32_t, 3>& low,
                       const std::array<std::int32_t, 3>& high);

// The points of a tree: the place of each on a grid.
struct OctreePoints {
  std::size_t count = 0;
  las::Grid grid;
  std::function<std::array<std::int32_t, 3>(std::size_t)> steps;
};

// A node with more points than `node_points` keeps the first one of each cell of a grid, 128 cells across, and hands
// the others to its eight children; a child that would have fewer than `min_points` is kept. Takes 9 bytes for each
// point. Deterministic at any number of threads. Throws Error{bad_input} for coordinates that the grid of the file
// cannot hold and beyond 2^32 points, Error{cancelled}.
struct OctreeOptions {
  std::size_t node_points = 65'536;
  std::size_t min_points = 512;
  std::optional<OctreeRoot> root;  // where the tree begins; nothing: with a cube around the points
};
Octree build_octree(const OctreePoints& points, const Run& run, const OctreeOptions& options = {});

}  // namespace bole::io::copc
