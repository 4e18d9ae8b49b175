// The pages of a COPC file that say where each node of the octree lies.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "io/core/copc/copc_octree.h"
#include "io/core/laz/laz_chunks.h"

namespace bole::io::copc {

struct Hierarchy {
  std::vector<std::uint8_t> bytes;  // all pages, the root's first
  std::uint64_t root_size = 0;      // bytes of the page of the root
};

// `chunks`: of the nodes, in their order. `offset`: where the bytes will lie in the file. Large octrees get several
// pages, so that a reader of a small part need not read all.
Hierarchy make_hierarchy(const Octree& octree, const std::vector<laz::Chunk>& chunks, std::uint64_t offset);

// The data of the record "copc" 1. `times`: the least and the greatest GPS time, 0 where there are none.
std::vector<std::uint8_t> info_record(const Octree& octree, const Hierarchy& hierarchy, std::uint64_t hierarchy_offset,
                                      std::array<double, 2> times);

}  // namespace bole::io::copc
