// Universal Transverse Mercator.
#pragma once

#include "geo/core/transverse_mercator.h"

namespace bole::geo {

struct UtmPoint {
  int zone = 0;  // 1 to 60, with the exceptions of Norway and Svalbard
  bool north = true;
  double easting_m = 0, northing_m = 0;  // WGS84; false northing 10 000 km in the south
};

// In the standard zone of the point, or in `zone` when it is not 0. Latitudes from -80 to 84 deg: Error{bad_input}
// beyond, where UPS is used.
UtmPoint to_utm(const GeodeticPoint& point, int zone = 0);
GeodeticPoint from_utm(const UtmPoint& point);

// The plane of a zone.
TransverseMercatorPlane utm_plane(int zone, bool north);

}  // namespace bole::geo
