#include "geo/core/transverse_mercator.h"

#include <fmt/format.h>

#include <GeographicLib/Ellipsoid.hpp>
#include <GeographicLib/TransverseMercatorExact.hpp>
#include <cmath>

#include "base/angles.h"
#include "base/error.h"

namespace bole::geo {

namespace {

constexpr double max_difference_deg = 80;  // GeographicLib's own domain ends at 90 (1 - e) degrees, about 82.6

void check_plane(const TransverseMercatorPlane& p) {
  const auto& e = p.ellipsoid;
  if (!(e.semi_major_m > 0) || !(e.inverse_flattening > 1) || !std::isfinite(e.semi_major_m + e.inverse_flattening))
    throw bad_input(fmt::format("ellipsoid '{}' has semi-major axis {} m and inverse flattening {}", e.name,
                                e.semi_major_m, e.inverse_flattening),
                    "a flattened ellipsoid such as GRS80");
  if (!(p.scale > 0) || !std::isfinite(p.scale + p.false_easting_m + p.false_northing_m) ||
      !(std::abs(p.central_meridian_deg) <= 360) || !(std::abs(p.latitude_of_origin_deg) <= 90))
    throw bad_input(
        fmt::format("a plane with central meridian {} deg, latitude of origin {} deg, scale {}, false "
                    "easting {} m, false northing {} m",
                    p.central_meridian_deg, p.latitude_of_origin_deg, p.scale, p.false_easting_m, p.false_northing_m),
        "finite values, a positive scale, a meridian from -360 to 360 deg and a latitude from -90 to 90");
}

// Of the plane's origin from the equator, along the central meridian.
double origin_arc_m(const TransverseMercatorPlane& plane) {
  const auto& e = plane.ellipsoid;
  return plane.latitude_of_origin_deg == 0
             ? 0
             : GeographicLib::Ellipsoid(e.semi_major_m, e.flattening()).MeridianDistance(plane.latitude_of_origin_deg);
}

double checked_difference_deg(const GeodeticPoint& point, const TransverseMercatorPlane& plane) {
  check_geodetic(point);
  const double difference = longitude_difference_deg(point.longitude_deg, plane.central_meridian_deg);
  if (std::abs(difference) > max_difference_deg)
    throw bad_input(fmt::format("longitude {} deg is {:.1f} deg from the central meridian {} deg", point.longitude_deg,
                                std::abs(difference), plane.central_meridian_deg),
                    fmt::format("at most {:g} deg", max_difference_deg), "Choose the zone that the point lies in");
  return difference;
}

}  // namespace

void check_geodetic(const GeodeticPoint& p) {
  if (!std::isfinite(p.latitude_deg + p.longitude_deg + p.height_m) || std::abs(p.latitude_deg) > 90)
    throw bad_input(fmt::format("latitude {}, longitude {}, height {}", p.latitude_deg, p.longitude_deg, p.height_m),
                    "a latitude from -90 to 90 deg and finite numbers", "Are latitude and longitude swapped?");
}

double longitude_difference_deg(double longitude_deg, double from_deg) {
  const double d = std::remainder(longitude_deg - from_deg, 360.0);
  return d >= 180 ? d - 360 : d;
}

double GaussKruegerZone::central_meridian_deg() const {
  const double meridian = width_deg == 3 ? 3.0 * number : 6.0 * number - 3;
  return meridian > 180 ? meridian - 360 : meridian;
}

GaussKruegerZone gauss_krueger_zone(double longitude_deg, int width_deg) {
  if (width_deg != 3 && width_deg != 6)
    throw bad_input(fmt::format("Gauss-Krueger zones of {} deg", width_deg), "zones of 3 or 6 deg");
  if (!std::isfinite(longitude_deg)) throw bad_input("a longitude that is not a number", "degrees");
  const double east = longitude_deg - 360 * std::floor(longitude_deg / 360);  // [0, 360)
  if (width_deg == 6) return {6, static_cast<int>(std::floor(east / 6)) % 60 + 1};
  const int number = static_cast<int>(std::floor(east / 3 + 0.5)) % 120;
  return {3, number == 0 ? 120 : number};
}

TransverseMercatorPlane gauss_krueger_plane(const GaussKruegerZone& zone, const Ellipsoid& ellipsoid,
                                            bool zone_prefix) {
  if ((zone.width_deg != 3 && zone.width_deg != 6) || zone.number < 1 || zone.number > 360 / zone.width_deg)
    throw bad_input(fmt::format("Gauss-Krueger zone {} of {} deg", zone.number, zone.width_deg),
                    "3-degree zones 1 to 120 or 6-degree zones 1 to 60");
  TransverseMercatorPlane plane;
  plane.ellipsoid = ellipsoid;
  plane.central_meridian_deg = zone.central_meridian_deg();
  if (zone_prefix) plane.false_easting_m += 1e6 * zone.number;
  return plane;
}

class TransverseMercator::Exact {
 public:
  GeographicLib::TransverseMercatorExact projection;
};

TransverseMercator::TransverseMercator(const TransverseMercatorPlane& plane) : plane_(plane) {
  check_plane(plane);
  northing_of_equator_m_ = plane.false_northing_m - plane.scale * origin_arc_m(plane);
  exact_ =
      std::make_unique<const Exact>(Exact{{plane.ellipsoid.semi_major_m, plane.ellipsoid.flattening(), plane.scale}});
}

TransverseMercator::~TransverseMercator() = default;
TransverseMercator::TransverseMercator(TransverseMercator&&) noexcept = default;
TransverseMercator& TransverseMercator::operator=(TransverseMercator&&) noexcept = default;

PlanePoint TransverseMercator::forward(const GeodeticPoint& point) const {
  const double difference = checked_difference_deg(point, plane_);
  PlanePoint p;
  exact_->projection.Forward(0, point.latitude_deg, difference, p.easting_m, p.northing_m, p.convergence_deg, p.scale);
  p.easting_m += plane_.false_easting_m;
  p.northing_m += northing_of_equator_m_;
  return p;
}

GeodeticPoint TransverseMercator::inverse(double easting_m, double northing_m) const {
  const double x = easting_m - plane_.false_easting_m, y = northing_m - northing_of_equator_m_;
  GeodeticPoint point;
  double difference = 0;
  // The image of the domain is about 2.4 quarter meridians wide; beyond it the inverse would wrap around silently.
  const double widest_m = 2.5 * plane_.scale * plane_.ellipsoid.semi_major_m;
  if (std::isfinite(x + y) && std::abs(x) < widest_m && std::abs(y) < widest_m)
    exact_->projection.Reverse(0, x, y, point.latitude_deg, difference);
  else
    difference = std::nan("");
  if (!(std::abs(difference) <= max_difference_deg + 1e-9 || std::abs(point.latitude_deg) > 89))
    throw bad_input(fmt::format("easting {} m, northing {} m lies outside the plane", easting_m, northing_m),
                    fmt::format("an easting near {} m", plane_.false_easting_m),
                    "Check the false easting and whether the zone number stands before the easting");
  point.longitude_deg = longitude_difference_deg(plane_.central_meridian_deg + difference, 0);
  return point;
}

std::string TransverseMercator::wkt() const {
  const auto& e = plane_.ellipsoid;
  return fmt::format(
      R"(PROJCS["Transverse Mercator, {0}, {1:g} E",GEOGCS["GCS {0}",DATUM["{2}",SPHEROID["{0}",{3:.10g},{4:.15g}]],)"
      R"(PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]],PROJECTION["Transverse_Mercator"],)"
      R"(PARAMETER["latitude_of_origin",{8:.15g}],PARAMETER["central_meridian",{1:.15g}],PARAMETER["scale_factor",{5:.15g}],)"
      R"(PARAMETER["false_easting",{6:.15g}],PARAMETER["false_northing",{7:.15g}],UNIT["metre",1],)"
      R"(AXIS["Easting",EAST],AXIS["Northing",NORTH]])",
      e.name, plane_.central_meridian_deg, e.datum, e.semi_major_m, e.inverse_flattening, plane_.scale,
      plane_.false_easting_m, plane_.false_northing_m, plane_.latitude_of_origin_deg);
}

PlanePoint gauss_krueger_series(const GeodeticPoint& point, const TransverseMercatorPlane& plane) {
  check_plane(plane);
  const double l = checked_difference_deg(point, plane) * rad_per_deg, latitude = point.latitude_deg * rad_per_deg;
  const auto& e = plane.ellipsoid;
  const double arc = GeographicLib::Ellipsoid(e.semi_major_m, e.flattening()).MeridianDistance(point.latitude_deg);
  const double s = std::sin(latitude), c = std::cos(latitude), t2 = s * s / (c * c);
  const double eta2 = e.second_eccentricity_squared() * c * c;
  const double n = e.semi_major_m / std::sqrt(1 - e.first_eccentricity_squared() * s * s);
  const double l2 = l * l, c2 = c * c;
  const double x = arc + l2 / 2 * n * s * c + l2 * l2 / 24 * n * s * c * c2 * (5 - t2 + 9 * eta2 + 4 * eta2 * eta2) +
                   l2 * l2 * l2 / 720 * n * s * c * c2 * c2 * (61 - 58 * t2 + t2 * t2);
  const double y = l * n * c + l * l2 / 6 * n * c * c2 * (1 - t2 + eta2) +
                   l * l2 * l2 / 120 * n * c * c2 * c2 * (5 - 18 * t2 + t2 * t2 + 14 * eta2 - 58 * eta2 * t2);
  PlanePoint p;
  p.easting_m = plane.false_easting_m + plane.scale * y;
  p.northing_m = plane.false_northing_m + plane.scale * (x - origin_arc_m(plane));
  p.convergence_deg = l * s / rad_per_deg;  // first terms only: the paper gives neither
  p.scale = plane.scale * (1 + l2 / 2 * c2 * (1 + eta2));
  return p;
}

}  // namespace bole::geo
