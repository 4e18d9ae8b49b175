// The points of a LAZ file.
#pragma once

#include "base/run.h"
#include "io/core/las/las_columns.h"
#include "io/core/las/las_info.h"

namespace bole::io::laz {

// Decodes the points into `builder` and returns how many are sound. Memory grows with the points that are decoded, not
// with the number in the header. Chunks are decoded in parallel where there is a chunk table, else in order. More than
// `columns_in_memory` bytes of columns lie on file where the chunk table is plausible.
// Throws Error{bad_input} when the file lacks its LAZ record, Error{cancelled}.
std::uint64_t read_points(Bytes file, const LasInfo& info, las::ColumnBuilder& builder, std::size_t columns_in_memory,
                          las::IntegerBox& box, const Run& run, std::vector<std::string>& warnings);

}  // namespace bole::io::laz
