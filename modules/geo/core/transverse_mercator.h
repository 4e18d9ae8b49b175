// Geodetic <-> plane: Gauss-Krueger zones and any other transverse Mercator plane.
#pragma once

#include <memory>
#include <string>

#include "geo/core/ellipsoid.h"
#include "geo/core/geodetic.h"

namespace bole::geo {

// A transverse Mercator plane: easting = false_easting + scale * y, northing = false_northing + scale * (x - x0), x0 on
// the central meridian at the latitude of origin.
struct TransverseMercatorPlane {
  Ellipsoid ellipsoid = grs80();
  double central_meridian_deg = 0;
  double scale = 1;  // on the central meridian; 1: Gauss-Krueger, 0.9996: UTM
  double false_easting_m = 500'000;
  double false_northing_m = 0;
  double latitude_of_origin_deg = 0;  // where the northing is the false one
};

struct PlanePoint {
  double easting_m = 0, northing_m = 0;
  double convergence_deg = 0;  // bearing of grid north, clockwise from true north
  double scale = 1;            // length on the plane over length on the ellipsoid
};

// A Gauss-Krueger zone. 3-degree zones have their central meridians at 3, 6, 9 ... degrees (zone = meridian / 3),
// 6-degree zones at 3, 9, 15 ... (zone = (meridian + 3) / 6), eastwards from Greenwich.
struct GaussKruegerZone {
  int width_deg = 3;  // 3 or 6
  int number = 1;     // 1 to 120 or 1 to 60
  double central_meridian_deg() const;
};

// The zone whose central meridian is nearest. Throws Error{bad_input} for a width other than 3 and 6.
GaussKruegerZone gauss_krueger_zone(double longitude_deg, int width_deg);

// The plane of a zone; with `zone_prefix` the number stands before the easting (39 500 000), as on Chinese and former
// German sheets.
TransverseMercatorPlane gauss_krueger_plane(const GaussKruegerZone& zone, const Ellipsoid& ellipsoid = grs80(),
                                            bool zone_prefix = false);

// The projection itself by Lee's exact formulas, good to 10 nm anywhere but near the two points of branching (Karney
// 2011), through GeographicLib::TransverseMercatorExact.
class TransverseMercator {
 public:
  explicit TransverseMercator(const TransverseMercatorPlane& plane);  // throws Error{bad_input}
  ~TransverseMercator();
  TransverseMercator(TransverseMercator&&) noexcept;
  TransverseMercator& operator=(TransverseMercator&&) noexcept;

  const TransverseMercatorPlane& plane() const { return plane_; }
  // Throws Error{bad_input} further than 80 degrees from the central meridian, where a plane serves nobody.
  PlanePoint forward(const GeodeticPoint& point) const;
  // Height zero; longitude in [-180, 180). Throws Error{bad_input} for a point outside the plane's domain.
  GeodeticPoint inverse(double easting_m, double northing_m) const;

  // Well-known text (WKT 1) of the plane, which PROJ and GDAL read.
  std::string wkt() const;

 private:
  class Exact;
  TransverseMercatorPlane plane_;
  double northing_of_equator_m_ = 0;
  std::unique_ptr<const Exact> exact_;
};

// The series of the paper on auto-steering (SPEC E1, eqs. 1 to 3), terms up to l^6, misprints put right: cos^5 B for
// cos 5B, e^2 = 2f - f^2, and the meridian arc X = c * integral of (1 + e'^2 cos^2 B)^(-3/2) dB. Against the exact
// projection it is off by 0.001 mm at 1.5 degrees from the central meridian and by 0.1 mm at 3 degrees.
PlanePoint gauss_krueger_series(const GeodeticPoint& point, const TransverseMercatorPlane& plane);

}  // namespace bole::geo
