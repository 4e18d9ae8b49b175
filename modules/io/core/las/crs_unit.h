// The unit that a coordinate reference system counts in.
#pragma once

#include <optional>
#include <string>

namespace bole::io::las {

// Metres per unit of the coordinates of a WKT: 1 where GDAL does not know the system. Nothing where they are degrees.
std::optional<double> metres_per_crs_unit(const std::string& wkt);

}  // namespace bole::io::las
