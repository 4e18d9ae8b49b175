// E57 (ASTM E2807): scans of static scanners, each with the pose that takes it into the common coordinate system.
#pragma once

#include "io/core/clouds/cloud_reader.h"

namespace bole::io {

// Points of all scans in the common coordinate system, with `scan` (number in the file, from 0) and, where there are
// several scans, the same as `pass`. Images are counted and skipped. Records with the state invalid are dropped and
// counted.
//
// Where a scan stood is known from its pose (E57 axes have the scanner in the origin of the scan). Then the cloud has
// `range`, `sensor_x`, `sensor_y` and `sensor_z` of its points: see ScanPositions.
//
// What lies in pages with a wrong checksum is dropped and counted. Throws Error{bad_input} where no point can be read.
CloudReading read_e57(Bytes file, const CloudReadOptions& options, const Run& run);

}  // namespace bole::io
