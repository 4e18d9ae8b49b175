// The points of a LAZ file.
#pragma once

#include "base/run.h"
#include "io/core/las/las_columns.h"
#include "io/core/las/las_info.h"
#include "io/core/las/las_selection.h"
#include "io/core/laz/laz_chunks.h"

namespace bole::io::laz {

struct PointsWanted {
  const las::RecordSelection* selection = nullptr;  // null: all points
  // Chunks to read, each apart from the others, so that a damaged one costs only its own points. Needs a selection.
  // null: all, as the chunk table of the file says.
  const std::vector<Chunk>* chunks = nullptr;
};

struct PointsRead {
  std::uint64_t sound = 0;  // points decoded, also those that were not selected
  las::IntegerBox box;      // of the points in the builder
};

// The chunks of a file that has a usable chunk table; nothing for others, which are read in order. Throws
// Error{bad_input} when the file lacks its LAZ record.
std::optional<std::vector<Chunk>> chunks_of(Bytes file, const LasInfo& info);

// Decodes the points into `builder`. Memory grows with the points that are decoded, not with the number in the header.
// Chunks are decoded in parallel where there is a chunk table, else in order. Throws Error{bad_input} when the file
// lacks its LAZ record, Error{cancelled}.
PointsRead read_points(Bytes file, const LasInfo& info, las::ColumnBuilder& builder, const PointsWanted& wanted,
                       const Run& run, std::vector<std::string>& warnings);

}  // namespace bole::io::laz
