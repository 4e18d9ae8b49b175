// Writes the points of a LAZ file.
#pragma once

#include <fstream>
#include <span>
#include <vector>

#include "base/run.h"
#include "io/core/las/las_header.h"
#include "io/core/las/las_records.h"
#include "io/core/laz/laz_chunks.h"

namespace bole::io::laz {

struct PointsWritten {
  std::vector<Chunk> chunks;  // places in the file
  std::uint64_t end = 0;      // behind the chunk table
  las::RecordStatistics statistics;
  las::RecordLosses losses;
};

// Compresses each list of points to a chunk, several at once, and writes the chunks in their order, then their table.
// The stream stands at `data_offset`, where the points begin, and at `end` afterwards. Memory is taken for a few chunks
// for each thread. Throws what RecordEncoder::encode() throws, and Error{cancelled}. Errors of the stream are left to
// the caller.
PointsWritten write_points(std::ofstream& out, std::uint64_t data_offset, const PointCloud& cloud,
                           const las::RecordEncoder& encoder, const Packing& packing,
                           std::span<const las::PointList> lists, const Run& run);

}  // namespace bole::io::laz
