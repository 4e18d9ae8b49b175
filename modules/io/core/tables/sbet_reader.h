// Trajectories in SBET files: smoothed best estimates of a GNSS and inertial unit.
#pragma once

#include <string>

#include "cloud/trajectory.h"
#include "io/core/bytes/mapped_file.h"

namespace bole::io {

// Records of 17 doubles: time, latitude, longitude (rad), height, ... Whether the first and last records can be such.
bool looks_like_sbet(Bytes file);

// Positions are longitude, latitude (degrees) and height above the ellipsoid (fact `crs`), the orientation is not read
// (fact `orientation`). Records that repeat a time or cannot be right are left out (facts `repeated_times`,
// `impossible_records`). Throws Error{bad_input} where the first record cannot be one.
Trajectory read_sbet(Bytes file, const std::string& name);

}  // namespace bole::io
