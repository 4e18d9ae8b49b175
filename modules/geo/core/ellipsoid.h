// Reference ellipsoids.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace bole::geo {

struct Ellipsoid {
  std::string name;  // as options and WKT give it
  double semi_major_m = 0;
  double inverse_flattening = 0;

  double flattening() const { return 1 / inverse_flattening; }
  double semi_minor_m() const { return semi_major_m * (1 - flattening()); }
  double first_eccentricity_squared() const { return flattening() * (2 - flattening()); }
  double second_eccentricity_squared() const {
    return first_eccentricity_squared() / (1 - first_eccentricity_squared());
  }
};

// GRS80 (Moritz 1980), WGS84 (NIMA TR8350.2) and CGCS2000 (GB 22021-2008): their semi-major axes agree, their
// flattenings differ in the 9th digit and beyond, which is 0.1 mm on the ground.
const Ellipsoid& grs80();
const Ellipsoid& wgs84();
const Ellipsoid& cgcs2000();

const std::vector<std::string>& ellipsoid_names();
const Ellipsoid& ellipsoid_named(std::string_view name);  // throws Error{bad_input}

}  // namespace bole::geo
