// The octree of a COPC file that is written: which points lie in which node.
#pragma once

#include <Eigen/Core>
#include <cstdint>
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

// A node with more points than `node_points` keeps the first one of each cell of a grid, 128 cells across, and hands
// the others to its eight children; a child that would have fewer than `min_points` is kept. Takes 9 bytes for each
// point. Deterministic at any number of threads. Throws Error{bad_input} for coordinates that the grid of the file
// cannot hold and beyond 2^32 points, Error{cancelled}.
struct OctreeOptions {
  std::size_t node_points = 65'536;
  std::size_t min_points = 512;
};
Octree build_octree(const las::RecordEncoder& encoder, std::size_t points, const Run& run,
                    const OctreeOptions& options = {});

}  // namespace bole::io::copc
