#include "geo/core/utm.h"

#include <fmt/format.h>

#include <GeographicLib/UTMUPS.hpp>

#include "base/error.h"

namespace bole::geo {

UtmPoint to_utm(const GeodeticPoint& point, int zone) {
  check_geodetic(point);
  if (point.latitude_deg < -80 || point.latitude_deg > 84)
    throw bad_input(fmt::format("latitude {} deg lies outside UTM", point.latitude_deg), "-80 to 84 deg");
  if (zone < 0 || zone > 60) throw bad_input(fmt::format("UTM zone {}", zone), "1 to 60, or 0 for the standard zone");
  UtmPoint utm;
  using GeographicLib::UTMUPS;
  try {
    const int set = zone == 0 ? static_cast<int>(UTMUPS::STANDARD) : zone;
    UTMUPS::Forward(point.latitude_deg, point.longitude_deg, utm.zone, utm.north, utm.easting_m, utm.northing_m, set);
  } catch (const GeographicLib::GeographicErr& e) {
    throw bad_input(fmt::format("latitude {}, longitude {} in UTM zone {}: {}", point.latitude_deg, point.longitude_deg,
                                zone, e.what()),
                    "a zone near the point");
  }
  return utm;
}

GeodeticPoint from_utm(const UtmPoint& utm) {
  GeodeticPoint point;
  try {
    if (utm.zone < 1 || utm.zone > 60) throw GeographicLib::GeographicErr("zone is not from 1 to 60");
    GeographicLib::UTMUPS::Reverse(utm.zone, utm.north, utm.easting_m, utm.northing_m, point.latitude_deg,
                                   point.longitude_deg);
  } catch (const GeographicLib::GeographicErr& e) {
    throw bad_input(fmt::format("UTM zone {} {}, easting {} m, northing {} m: {}", utm.zone, utm.north ? "N" : "S",
                                utm.easting_m, utm.northing_m, e.what()),
                    "coordinates of that zone");
  }
  return point;
}

TransverseMercatorPlane utm_plane(int zone, bool north) {
  if (zone < 1 || zone > 60) throw bad_input(fmt::format("UTM zone {}", zone), "1 to 60");
  return {wgs84(), 6.0 * zone - 183, 0.9996, 500'000, north ? 0.0 : 10'000'000.0, 0};
}

}  // namespace bole::geo
