// A projected coordinate reference system in metres, by its EPSG code or as WKT.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "geo/core/geodetic.h"
#include "geo/core/transverse_mercator.h"

namespace bole::geo {

// Transverse Mercator planes (UTM, Gauss-Krueger, national grids) are computed by GeographicLib (TransverseMercator),
// others by PROJ.
class ProjectedCrs {
 public:
  // "EPSG:25832", "25832", or WKT 1 or 2. Throws Error{bad_input} where PROJ does not know it, where it is geographic
  // (degrees) or geocentric, and where its unit is not the metre.
  explicit ProjectedCrs(const std::string& definition);
  ~ProjectedCrs();
  ProjectedCrs(ProjectedCrs&&) noexcept;
  ProjectedCrs& operator=(ProjectedCrs&&) noexcept;

  const std::string& name() const;  // "ETRS89 / UTM zone 32N"
  const std::string& code() const;  // "EPSG:25832"; empty where it has none
  const std::string& wkt() const;   // WKT 1, which LAS, GeoPackage and GeoTIFF hold; WKT 2 where it has no WKT 1
  // "EPSG:25832 (ETRS89 / UTM zone 32N)"
  std::string title() const;
  bool is_transverse_mercator() const;
  double false_easting_m() const;

  // Of latitude and longitude in the system's own datum. Throws Error{bad_input} outside its domain.
  PlanePoint forward(const GeodeticPoint& point) const;
  GeodeticPoint inverse(double easting_m, double northing_m) const;

  // Where the system may be used, as its registry says; nothing where it does not.
  struct Area {
    double west_deg = 0, south_deg = 0, east_deg = 0, north_deg = 0;
    // With a margin: receivers near the border of a zone stay in it.
    bool holds(const GeodeticPoint& point, double margin_deg) const;
  };
  const std::optional<Area>& area() const;
  // False where a point lies far outside the area, or so far from the central meridian that no survey uses the plane.
  bool plausible(const GeodeticPoint& point) const;
  bool plausible(double easting_m, double northing_m) const;

  // Distance on the plane between a point in the system's datum and the same numbers taken for WGS84: 0 for ETRS89,
  // CGCS2000 and others that agree with WGS84 to less than metres, about a hundred metres for old datums. NaN where
  // PROJ has no transformation.
  double datum_shift_m(const GeodeticPoint& point) const;

  // Length on the plane over length on the ground at a height above the ellipsoid: the projection's scale times the
  // reduction of the height.
  double ground_scale(double easting_m, double northing_m, double height_m) const;

 private:
  class System;
  std::unique_ptr<const System> system_;
};

// The UTM zone of a position, on WGS84: "EPSG:32632".
std::string utm_code(const GeodeticPoint& point);

}  // namespace bole::geo
