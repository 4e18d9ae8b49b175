// One frame of the KITTI data sets as a cloud: x, y, z and intensity of every point as little-endian float32.
#pragma once

#include "io/core/clouds/cloud_reader.h"

namespace bole::io {

// Bytes behind the last whole point are warned of.
// Whether a file without any mark of its own may be a frame: whole points, and values that a sensor can give.
bool looks_like_kitti_frame(Bytes file);

CloudReading read_kitti_frame(Bytes file, const CloudReadOptions& options, const Run& run);

}  // namespace bole::io
