// PTX (Leica Cyclone): gridded scans, each with the pose that takes it into the common coordinate system.
#pragma once

#include "io/core/clouds/cloud_reader.h"

namespace bole::io {

// Whether the first two lines hold one number each, as the size of a grid does.
bool looks_like_ptx(Bytes file);

// Points in the common coordinate system. Cells without a return (0 0 0) are left out. Throws Error{bad_input} that
// names the line.
CloudReading read_ptx(Bytes file, const CloudReadOptions& options, const Run& run);

}  // namespace bole::io
