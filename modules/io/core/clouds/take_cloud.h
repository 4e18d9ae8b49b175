// A cloud that is in memory already, taken as if it had been read from a file.
#pragma once

#include "io/core/clouds/cloud_reader.h"

namespace bole::io {

// Coordinates are turned to metres with z up and cut to the bounds, names of arrays become Bole's, points whose
// coordinates are not numbers are dropped and counted: as read_cloud() does it. Facts, coordinate system and, unless
// the options name them, axes stay those of the cloud. Throws Error{bad_input} where nothing lies within the bounds.
CloudReading take_cloud(const PointCloud& given, const CloudReadOptions& options = {}, const Run& run = {});

}  // namespace bole::io
