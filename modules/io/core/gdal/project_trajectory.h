// Longitude, latitude and height of a path in a projected coordinate system.
#pragma once

#include <string>

#include "cloud/trajectory.h"

namespace bole::io {

// `crs`: anything that GDAL takes, for instance EPSG:25832 or WKT. Times stay; orientations stay those of the local
// level system and are not turned. Throws Error{bad_input}.
void project_trajectory(Trajectory& trajectory, const std::string& crs);

}  // namespace bole::io
