// Trajectories of other programs: text with a line that names its columns (GeoSLAM, HDMapping, NavVis, CSV).
#pragma once

#include <string>

#include "cloud/trajectory.h"
#include "io/core/bytes/mapped_file.h"

namespace bole::io {

// Whether the first line names columns of time and place.
bool looks_like_named_trajectory(Bytes file);

// Columns are known by their names, in any order:
//   time in s, or in ms, us or ns where the name says so;
//   x y z, or longitude and latitude in degrees with a height;
//   qw qx qy qz, or q0 q1 q2 q3 with the scalar first (GeoSLAM), or the matrix pose00 ... pose23 (HDMapping), or none:
//   then the orientation is not known (fact `orientation`).
// Lines that repeat the time of the line above are left out (fact `repeated_times`). Throws Error{bad_input} that names
// the line where numbers are missing or time goes back.
Trajectory read_named_trajectory(Bytes file, const std::string& name);

// The fact `crs` of a trajectory whose positions are longitude, latitude (degrees) and height above the ellipsoid.
inline constexpr const char* geographic_crs = "EPSG:4979";
bool is_geographic(const Trajectory& trajectory);

}  // namespace bole::io
