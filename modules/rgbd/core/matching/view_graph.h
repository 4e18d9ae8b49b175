// Which views see the same things, and first poses from their relative motions.
#pragma once

#include <optional>
#include <vector>

#include "rgbd/core/matching/match_pair.h"

namespace bole::rgbd {

// The relative motion of two nodes, and how much it is trusted.
struct GraphEdge {
  int a = 0, b = 0;
  Pose T_b_a = Pose::Identity();
  double weight = 0;
};

// Poses T_root_node along the maximum spanning tree of the largest connected part; nothing for nodes outside of it.
// `root`: the node whose axes are used where it lies in that part, else its first node.
struct SpannedPoses {
  std::vector<std::optional<Pose>> T_root_node;
  int root = 0;
  int nodes = 0;  // in the part
};
SpannedPoses span_poses(int nodes, const std::vector<GraphEdge>& edges, int root);

// Edges whose motions contradict those of the triangles that they are part of, more often than they agree.
std::vector<char> contradicted(int nodes, const std::vector<GraphEdge>& edges, double max_turn_rad, double max_shift);

}  // namespace bole::rgbd
