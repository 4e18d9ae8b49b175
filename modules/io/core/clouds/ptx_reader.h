// PTX (Leica Cyclone): one or more gridded scans, each with the pose that takes it into the common system.
#pragma once

#include "io/core/clouds/cloud_reader.h"

namespace bole::io {

bool looks_like_ptx(Bytes file, const std::string& extension);

// Points in the common system; the cells without a return (0 0 0) are left out. Throws Error{bad_input} naming the
// line.
CloudReading read_ptx(Bytes file, const CloudReadOptions& options, const Run& run);

}  // namespace bole::io
