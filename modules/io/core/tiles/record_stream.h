// The point records of a LAS or LAZ file as they are, in the order of the file.
#pragma once

#include <functional>

#include "base/report.h"
#include "base/run.h"
#include "io/core/las/las_info.h"

namespace bole::io::las {

// Calls f(records, count) for stretches of uncompressed records, from this thread; decoding runs in several. Memory is
// taken for a few stretches. A file that is cut off gives the points that it holds, with a finding. Throws
// Error{bad_input} where a compressed file has no usable chunk table, Error{cancelled}.
void for_each_records(Bytes file, const LasInfo& info, const Run& run, Report& report,
                      const std::function<void(const std::uint8_t* records, std::size_t count)>& f);

}  // namespace bole::io::las
