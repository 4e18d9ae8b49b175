// Reference ellipsoids.
#pragma once

#include <array>
#include <string_view>

namespace bole::geo {

enum class EllipsoidName { grs80, wgs84, cgcs2000, airy1830, bessel1841, international1924, krassovsky1940 };
// As options and WKT give them.
constexpr std::array<std::string_view, 7> choice_names(EllipsoidName) {
  return {"GRS80", "WGS84", "CGCS2000", "Airy1830", "Bessel1841", "International1924", "Krassovsky1940"};
}

struct Ellipsoid {
  std::string_view name, datum;  // as WKT gives them
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

// The last four carry the grids of former surveys. Their axes are those of EPSG (7001, 7004, 7022, 7024).
const Ellipsoid& ellipsoid_of(EllipsoidName name);

}  // namespace bole::geo
