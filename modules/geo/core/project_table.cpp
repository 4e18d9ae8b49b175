#include "geo/core/project_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "geo/core/utm.h"

namespace bole::geo {

const OptionTable& option_table(const ProjectOptions*) {
  using S = ProjectOptions;
  static const OptionTable table = make_option_table<S>({
      Option<S, ProjectDirection>{"direction", &S::direction, Tier::basic,
                                  "to_plane: latitude and longitude become x_m and y_m; to_geodetic: the reverse."},
      Option<S, PlaneKind>{"plane", &S::plane, Tier::basic,
                           "Plane of the metres: Gauss-Krueger zones of 3 or 6 degrees, UTM, or any transverse "
                           "Mercator plane."},
      Option<S, EllipsoidName>{"ellipsoid", &S::ellipsoid, Tier::basic,
                               "Reference ellipsoid. Those named by a year belong to older datums: the degrees must be "
                               "of that datum already."},
      Option<S, std::optional<int>>{"zone",
                                    &S::zone,
                                    Unit::none,
                                    {1, 120},
                                    "auto",
                                    Tier::basic,
                                    "Number of the zone. auto: that of the mean longitude (to_plane only)."},
      Option<S, bool>{"south", &S::south, Tier::advanced, "The northings are those of the southern hemisphere."},
      Option<S, bool>{"zone_prefix", &S::zone_prefix, Tier::advanced, "The zone number precedes the easting."},
      Option<S, double>{"central_meridian",
                        &S::central_meridian_deg,
                        Unit::degree,
                        {-180, 360},
                        Tier::advanced,
                        "Central meridian of the plane."},
      Option<S, double>{"scale", &S::scale, Unit::none, {0.5, 2}, Tier::advanced, "Scale on the central meridian."},
      Option<S, double>{"false_easting",
                        &S::false_easting_m,
                        Unit::metre,
                        {-1e8, 2e8},
                        Tier::advanced,
                        "Easting of the central meridian."},
      Option<S, double>{
          "false_northing", &S::false_northing_m, Unit::metre, {-1e8, 1e8}, Tier::advanced, "Northing of the origin."},
      Option<S, double>{"latitude_of_origin",
                        &S::latitude_of_origin_deg,
                        Unit::degree,
                        {-90, 90},
                        Tier::advanced,
                        "Latitude at which the plane has its false northing."},
      Unless{"plane", {"utm"}, {"ellipsoid"}},
      Unless{"plane", {"transverse_mercator"}, {"zone"}},
      OnlyIf{"plane", {"utm"}, {"south"}},
      OnlyIf{"direction", {"to_geodetic"}, {"south"}},
      OnlyIf{"plane", {"gauss_krueger_3", "gauss_krueger_6"}, {"zone_prefix"}},
      OnlyIf{"plane",
             {"transverse_mercator"},
             {"central_meridian", "scale", "false_easting", "false_northing", "latitude_of_origin"}},
  });
  return table;
}

namespace {

// The mean of angles that may lie on both sides of the 180th meridian; NaN without any.
double mean_longitude_deg(const std::vector<double>& longitudes_deg) {
  double first = std::nan(""), sum = 0;
  int n = 0;
  for (const double l : longitudes_deg) {
    if (!std::isfinite(l)) continue;
    if (n == 0) first = l;
    sum += longitude_difference_deg(l, first);
    ++n;
  }
  return n == 0 ? first : longitude_difference_deg(first + sum / n, 0);
}

TransverseMercatorPlane plane_of_options(const ProjectOptions& o, double longitude_deg, double latitude_deg) {
  const auto& ellipsoid = ellipsoid_of(o.ellipsoid);
  if (o.plane == PlaneKind::transverse_mercator)
    return {ellipsoid,         o.central_meridian_deg, o.scale,
            o.false_easting_m, o.false_northing_m,     o.latitude_of_origin_deg};
  if (!o.zone && !std::isfinite(longitude_deg))
    throw bad_input("no zone is given, and the table has no longitude to derive it from", "the option zone");
  if (o.plane == PlaneKind::utm) {
    const bool from_points = std::isfinite(latitude_deg);
    const int zone = o.zone ? *o.zone : to_utm({latitude_deg, longitude_deg, 0}).zone;
    return utm_plane(zone, from_points ? latitude_deg >= 0 : !o.south);
  }
  const int width = o.plane == PlaneKind::gauss_krueger_6 ? 6 : 3;
  const auto zone = o.zone ? GaussKruegerZone{width, *o.zone} : gauss_krueger_zone(longitude_deg, width);
  return gauss_krueger_plane(zone, ellipsoid, o.zone_prefix);
}

double first_finite(const std::vector<double>& values) {
  for (const double v : values)
    if (std::isfinite(v)) return v;
  return std::nan("");
}

// A chain that takes receivers of both kinds needs no second pipeline for those that give metres.
Projected unchanged(const Table& table) {
  Projected result{table, {}};
  result.report.counts["points"] = static_cast<std::int64_t>(table.rows());
  result.report.counts["projected"] = 0;
  result.report.message = fmt::format("{} points have metres and no degrees: unchanged", table.rows());
  return result;
}

}  // namespace

Projected project_table(const Table& table, const ProjectOptions& o) {
  const bool forward = o.direction == ProjectDirection::to_plane;
  const bool geodetic = table.has("latitude_deg") && table.has("longitude_deg");
  const bool metres = (table.has("x_m") && table.has("y_m")) || (table.has("a_x_m") && table.has("a_y_m"));
  if (forward && !geodetic && metres) return unchanged(table);
  const auto a = table.numbers(forward ? "latitude_deg" : "x_m"), b = table.numbers(forward ? "longitude_deg" : "y_m");
  const auto definition = forward ? plane_of_options(o, mean_longitude_deg(b), first_finite(a))
                                  : plane_of_options(o, std::nan(""), std::nan(""));
  const TransverseMercator projection(definition);

  std::vector<double> first(a.size(), std::nan("")), second = first, convergence = first;
  double scale_error = 0;
  std::int64_t missing = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!std::isfinite(a[i]) || !std::isfinite(b[i])) {
      ++missing;
      continue;
    }
    try {
      if (forward) {
        const auto p = projection.forward({a[i], b[i], 0});
        first[i] = p.easting_m;
        second[i] = p.northing_m;
        convergence[i] = p.convergence_deg;
        scale_error = std::max(scale_error, std::abs(p.scale - 1));
      } else {
        const auto p = projection.inverse(a[i], b[i]);
        first[i] = p.latitude_deg;
        second[i] = p.longitude_deg;
      }
    } catch (const Error& e) {
      throw e.at(fmt::format("row {}", i + 1));
    }
  }

  Projected result{table, {}};
  result.table.set(forward ? "x_m" : "latitude_deg", std::move(first));
  result.table.set(forward ? "y_m" : "longitude_deg", std::move(second));
  if (forward) {
    result.table.set("convergence_deg", std::move(convergence));
    result.table.facts["axes"] = "global";
    result.table.facts["crs"] = projection.wkt();
  }
  auto& r = result.report;
  r.counts["points"] = static_cast<std::int64_t>(a.size()) - missing;
  r.counts["projected"] = r.counts["points"];
  r.counts["missing"] = missing;
  if (forward) r.metrics["scale_error"] = {100 * scale_error, Unit::percent};
  if (forward && (table.has("x_m") || table.has("y_m")))
    r.warn("x_m and y_m of the table are replaced by those of its latitude and longitude");
  r.metrics["central_meridian"] = {definition.central_meridian_deg, Unit::degree};
  r.message = fmt::format("{} points, central meridian {:g} deg, {}", a.size() - static_cast<std::size_t>(missing),
                          definition.central_meridian_deg, definition.ellipsoid.name);
  return result;
}

}  // namespace bole::geo
