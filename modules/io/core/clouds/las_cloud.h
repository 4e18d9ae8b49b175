// LAS and LAZ with the options of every cloud reader: unit, up axis, axes.
#pragma once

#include "io/core/clouds/cloud_reader.h"

namespace bole::io {

CloudReading read_las_cloud(Bytes file, const CloudReadOptions& options, const Run& run);

}  // namespace bole::io
