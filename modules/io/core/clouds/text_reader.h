// Points as text: XYZ, CSV, TXT and PTS (Leica: a count, then x y z intensity r g b).
#pragma once

#include "io/core/clouds/cloud_reader.h"

namespace bole::io {

// Whether one of the first 200 lines begins with three numbers.
bool holds_text_points(Bytes file);

// The delimiter, the header line and the columns are those of the options, or are found from the first lines. Lines
// without numbers are left out and counted, and the first one is named. Throws Error{bad_input} where they are more
// than half of the lines.
CloudReading read_text_cloud(Bytes file, const CloudReadOptions& options, const Run& run);

}  // namespace bole::io
