// The points of a plant thinned, moved onto the sheets that they lie on, and linked with their neighbours.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "base/run.h"
#include "plant/core/separate/point_grid.h"

namespace bole::plant {

struct PlantGraph {
  Points3 places;                        // of the nodes, in the axes and unit of the points
  std::vector<Eigen::Vector3d> normals;  // unit; their sign is arbitrary
  std::vector<double> flatness;          // 0: a thread or a lump, 1: a sheet
  std::vector<std::uint32_t> node_of_point;

  // The links of node i are first[i] to first[i + 1]. A cost is a length, increased where the link leaves a sheet,
  // crosses a crease, or bridges a gap between connected parts.
  std::vector<std::uint32_t> first, neighbour;
  std::vector<double> cost;

  double cell = 0;  // size of the cubes that hold one node each
  std::size_t gaps = 0;
  double widest_gap = 0;

  std::size_t size() const { return places.size(); }
};

// `cell`: distance between nodes; `noise`: standard deviation of the points across their surface; parts further from
// the others than `max_gap` stay unconnected.
PlantGraph plant_graph(const Points3& plant, double cell, double noise, double max_gap, const Run& run);

}  // namespace bole::plant
