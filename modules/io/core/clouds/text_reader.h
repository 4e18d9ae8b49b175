// Points as text: XYZ, CSV, TXT, PTS (Leica; a count, then x y z intensity r g b) and PTX (Leica; scans with their
// poses).
#pragma once

#include "io/core/clouds/cloud_reader.h"

namespace bole::io {

// The delimiter, the header line and the meaning of the columns are found out, or said by the options. Lines that do
// not hold numbers are left out, counted and the first one named; more than half of them is an error.
CloudReading read_text_cloud(Bytes file, const std::string& extension, const CloudReadOptions& options, const Run& run);

}  // namespace bole::io
