// Coordinate reference systems as GeoTIFF keys, as LAS 1.0 to 1.3 and older 1.4 files carry them.
#pragma once

#include <string>

#include "io/core/las/las_bytes.h"

namespace bole::io::las {

// The WKT of the keys (tags 34735, 34736 and 34737 as they are in the file), user-defined systems included. Made by
// GDAL. Empty where the keys name no system.
std::string wkt_from_geokeys(Bytes directory, Bytes doubles, Bytes ascii);

// A warning where the coordinates of a WKT are feet or degrees. Empty where they are metres or GDAL does not know the
// system.
std::string unit_warning(const std::string& wkt);

// The EPSG code of a WKT, 0 when it has none.
int epsg_of_wkt(const std::string& wkt);

}  // namespace bole::io::las
