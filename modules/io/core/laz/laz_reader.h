// The points of a LAZ file.
#pragma once

#include "base/run.h"
#include "io/core/las/las_columns.h"
#include "io/core/las/las_info.h"

namespace bole::io::laz {

// Decodes the points into `builder` (which grows with what the data really holds, not with what the header promises)
// and returns how many are sound. Chunks are decoded in parallel where there is a chunk table, else one after another.
// More than `columns_in_memory` bytes of columns lie on file where the chunk table can be believed.
// Throws Error{bad_input} when the file lacks its LAZ record, Error{cancelled}.
std::uint64_t read_points(Bytes file, const LasInfo& info, las::ColumnBuilder& builder, std::size_t columns_in_memory,
                          las::IntegerBox& box, const Run& run, std::vector<std::string>& warnings);

}  // namespace bole::io::laz
