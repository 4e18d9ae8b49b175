// PLY files (Stanford polygon format): the vertices, from ascii and both binary encodings.
// Source: G. Turk, "The PLY Polygon File Format".
#pragma once

#include "io/core/clouds/cloud_reader.h"

namespace bole::io {

bool looks_like_ply(Bytes file);

// All scalar types; list properties and other elements are skipped. Throws Error{bad_input} naming the header line that
// cannot be used. Points missing at the end are warned of.
CloudReading read_ply(Bytes file, const CloudReadOptions& options, const Run& run);

}  // namespace bole::io
