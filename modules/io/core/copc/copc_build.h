// Writes a COPC file of points that do not fit into memory.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "base/run.h"
#include "io/core/copc/copc_octree.h"
#include "io/core/las/las_header.h"

namespace bole::io::copc {

// Records of one form, in any order. They are asked for once, and a second time where they reach beyond `low` and
// `high`.
struct RecordStream {
  using Take = std::function<void(const std::uint8_t* records, std::size_t count)>;
  las::RecordForm form;                   // point formats 6 to 8
  std::array<std::int32_t, 3> low, high;  // of their steps, as far as known
  std::uint64_t points = 0;               // about
  las::VlrList vlrs;                      // coordinate system, extra bytes, facts
  unsigned encoding = 16;                 // global encoding of the header: the CRS is WKT
  std::function<void(const Run& run, const Take& take)> for_each;
  // Of sources that find records by place, used in its stead, so that nothing is sorted on disk: at least the records
  // of the box from `low` to `high`, all within the box above. Empty: for_each() it is.
  std::function<std::vector<std::uint8_t>(const std::array<std::int32_t, 3>& low,
                                          const std::array<std::int32_t, 3>& high)>
      within{};
};

struct BuildOptions {
  std::size_t memory_bytes = std::size_t{512} << 20;  // for records; the work takes about twice as much
  OctreeOptions octree;
};

struct BuiltFile {
  std::uint64_t points = 0;
  std::size_t nodes = 0, hierarchy_bytes = 0;
  int levels = 0;
};

// Records are sorted into cubes on disk, in a folder of its own in `scratch`, which takes the room of all records
// uncompressed. Each cube becomes a branch of the octree in memory (one that is too large is divided again); where
// branches meet, their upper node gives one point of each cell of its own grid to the node above, so that every node
// holds an even sample (as in untwine, H. Butler 2020). The file is the same at any number of threads and appears under
// its name only when it is whole. Throws Error{bad_input} where there are no points, Error{failed} when the disk is
// full, Error{cancelled}.
BuiltFile build_copc(const std::filesystem::path& path, const RecordStream& stream,
                     const std::filesystem::path& scratch, const BuildOptions& options = {}, const Run& run = {});

}  // namespace bole::io::copc
