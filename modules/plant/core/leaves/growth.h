// How a plant grows from its foot: distances along it, the ends of its organs, and levels of equal distance.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "plant/core/leaves/plant_graph.h"

namespace bole::plant {

inline constexpr std::uint32_t no_node = std::numeric_limits<std::uint32_t>::max();

struct Distances {
  std::vector<double> value;            // infinite where nothing leads
  std::vector<std::uint32_t> previous;  // on the way to the start; no_node at the start
  std::vector<std::uint32_t> origin;    // the start's index
};

// Shortest ways over the links from the nodes `starts` (Dijkstra). Of equal ways that of the lower node is taken.
Distances distances_from(const PlantGraph& graph, const std::vector<std::uint32_t>& starts, const Run& run);

// Of each node: whether it belongs to the largest connected part.
std::vector<bool> largest_part(const PlantGraph& graph);

// The node of an end of an organ, and how far it stands out: its distance less that of the place where the part beyond
// meets a part that reaches further.
struct OrganEnd {
  std::uint32_t node = 0;
  double stands_out = 0;
};

// Ends that stand out by at least `min_length`, the furthest first (persistence of the maxima of the distance).
std::vector<OrganEnd> organ_ends(const PlantGraph& graph, const Distances& from_foot, double min_length);

// Connected nodes whose distances lie in one step: cross-sections of stems and leaves. They form a tree.
struct Level {
  std::uint32_t parent = no_node;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  double distance = 0;  // mean
  double breadth = 0;   // length of an even line with the same scatter along its largest extent
  double depth = 0;     // the same across it
  std::size_t nodes = 0;
};

struct Levels {
  std::vector<Level> levels;
  std::vector<std::uint32_t> of_node;  // no_node: not connected with the foot
};
Levels levels_of(const PlantGraph& graph, const Distances& from_foot, double step);

}  // namespace bole::plant
