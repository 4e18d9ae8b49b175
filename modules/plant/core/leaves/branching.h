// Which levels of a plant are its main stem, its branches and its leaves.
#pragma once

#include <vector>

#include "plant/core/leaves/growth.h"

namespace bole::plant {

struct StemAxis {
  std::vector<std::uint32_t> levels;  // from its foot to its tip
  int parent = -1;                    // -1: the main stem
  std::uint32_t leaves_at = no_node;  // level of the parent that it grows from
};

struct Organ {
  std::uint32_t end = 0;              // node
  std::vector<std::uint32_t> levels;  // from the axis to the tip
  int axis = 0;
  std::uint32_t leaves_at = no_node;  // level of the axis
  bool through_other = false;         // its way to the axis leads through another organ: they touch
  bool ends_axis = false;             // the axis goes on into it: where it begins is to be found
};

struct Branching {
  std::vector<StemAxis> axes;  // the main stem first; empty where nothing grows from the foot
  std::vector<Organ> organs;   // leaves, and what else ends
};

struct BranchingScales {
  double organ = 0;  // shortest organ
  double tip = 0;    // shortest end of a stem without leaf
  double look = 0;   // length over which directions are taken
  double blade = 0;  // breadth from which on a level may be of a leaf
};

// `ends`: of organ_ends, from scales.tip on.
Branching branching_of(const Levels& levels, const std::vector<OrganEnd>& ends, const BranchingScales& scales);

}  // namespace bole::plant
