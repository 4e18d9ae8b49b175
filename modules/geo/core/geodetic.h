// Points on and above the ellipsoid.
#pragma once

namespace bole::geo {

// Geodetic coordinates as receivers and files give them: degrees, height above the ellipsoid in metres.
struct GeodeticPoint {
  double latitude_deg = 0;   // -90 to 90, north positive
  double longitude_deg = 0;  // east positive
  double height_m = 0;
};

// Throws Error{bad_input} for a latitude beyond the poles or a number that is not finite.
void check_geodetic(const GeodeticPoint& point);

// `longitude_deg` - `from_deg` brought to [-180, 180).
double longitude_difference_deg(double longitude_deg, double from_deg);

}  // namespace bole::geo
