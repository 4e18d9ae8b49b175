#include "geo/core/projected_crs.h"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <fmt/format.h>
#include <ogr_spatialref.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/angles.h"
#include "base/error.h"
#include "base/no_number.h"
#include "geo/core/utm.h"

namespace bole::geo {
namespace {

// Keeps messages of GDAL from standard error; the last one goes into ours.
class QuietErrors {
 public:
  QuietErrors() {
    CPLErrorReset();
    CPLPushErrorHandler(CPLQuietErrorHandler);
  }
  ~QuietErrors() { CPLPopErrorHandler(); }
  QuietErrors(const QuietErrors&) = delete;
  QuietErrors& operator=(const QuietErrors&) = delete;
};

std::string shortened(const std::string& text) {
  constexpr std::size_t longest = 80;
  return text.size() <= longest ? text : text.substr(0, longest) + " ...";
}

std::string trimmed(const std::string& text) {
  constexpr const char* blanks = " \t\r\n";
  const auto first = text.find_first_not_of(blanks);
  return first == std::string::npos ? std::string() : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

Error no_such_system(const std::string& definition, const std::string& found) {
  return bad_input(fmt::format("the coordinate reference system '{}' {}", shortened(definition), found),
                   "a projected system in metres, by EPSG code or as WKT, for instance EPSG:25832",
                   "Look the code up at epsg.org, or copy the WKT from your GIS");
}

// Only codes and WKT: GDAL would also open files and addresses of the network by their names.
OGRSpatialReference parsed(const std::string& definition) {
  const std::string text = trimmed(definition);
  if (text.empty()) throw no_such_system(definition, "is empty");
  OGRSpatialReference crs;
  const QuietErrors quiet;
  const bool digits = std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  std::string start = text.substr(0, 5);
  std::transform(start.begin(), start.end(), start.begin(),
                 [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
  const bool known =
      digits ? text.size() < 8 && crs.importFromEPSG(std::atoi(text.c_str())) == OGRERR_NONE
      : start == "EPSG:"
          ? crs.SetFromUserInput(text.c_str(), OGRSpatialReference::SET_FROM_USER_INPUT_LIMITATIONS) == OGRERR_NONE
      : text.find('[') != std::string::npos ? crs.importFromWkt(text.c_str()) == OGRERR_NONE
                                            : false;
  if (!known) throw no_such_system(definition, "is not known");
  crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return crs;
}

std::string exported(const OGRSpatialReference& crs, const char* format) {
  const QuietErrors quiet;
  char* text = nullptr;
  const std::string option = std::string("FORMAT=") + format;
  const char* const options[] = {option.c_str(), nullptr};
  std::string wkt;
  if (crs.exportToWkt(&text, options) == OGRERR_NONE && text != nullptr) wkt = text;
  CPLFree(text);
  return wkt;
}

std::string code_of(const OGRSpatialReference& crs) {
  const char* authority = crs.GetAuthorityName(nullptr);
  const char* code = crs.GetAuthorityCode(nullptr);
  return authority != nullptr && code != nullptr ? std::string(authority) + ":" + code : std::string();
}

std::optional<ProjectedCrs::Area> area_of(const OGRSpatialReference& crs) {
  const QuietErrors quiet;
  const auto read = [](const OGRSpatialReference& from) -> std::optional<ProjectedCrs::Area> {
    ProjectedCrs::Area a;
    if (!from.GetAreaOfUse(&a.west_deg, &a.south_deg, &a.east_deg, &a.north_deg, nullptr) || a.west_deg < -360)
      return std::nullopt;
    return a;
  };
  if (const auto area = read(crs)) return area;
  // WKT 1 has no area: that of its code.
  const auto code = code_of(crs);
  OGRSpatialReference registered;
  if (!code.starts_with("EPSG:") || registered.importFromEPSG(std::atoi(code.c_str() + 5)) != OGRERR_NONE)
    return std::nullopt;
  return read(registered);
}

std::optional<TransverseMercatorPlane> plane_of_crs(const OGRSpatialReference& crs) {
  const char* method = crs.GetAttrValue("PROJECTION");
  if (method == nullptr || !EQUAL(method, SRS_PT_TRANSVERSE_MERCATOR) || crs.GetPrimeMeridian(nullptr) != 0)
    return std::nullopt;
  TransverseMercatorPlane plane;
  plane.ellipsoid = {"of the system", "of the system", crs.GetSemiMajor(nullptr), crs.GetInvFlattening(nullptr)};
  if (!(plane.ellipsoid.inverse_flattening > 1)) return std::nullopt;  // a sphere
  plane.central_meridian_deg = crs.GetNormProjParm(SRS_PP_CENTRAL_MERIDIAN, 0);
  plane.latitude_of_origin_deg = crs.GetNormProjParm(SRS_PP_LATITUDE_OF_ORIGIN, 0);
  plane.scale = crs.GetNormProjParm(SRS_PP_SCALE_FACTOR, 1);
  plane.false_easting_m = crs.GetNormProjParm(SRS_PP_FALSE_EASTING, 0);
  plane.false_northing_m = crs.GetNormProjParm(SRS_PP_FALSE_NORTHING, 0);
  return plane;
}

using Transformation = std::unique_ptr<OGRCoordinateTransformation>;

Transformation transformation(const OGRSpatialReference& from, const OGRSpatialReference& to) {
  const QuietErrors quiet;
  return Transformation(OGRCreateCoordinateTransformation(&from, &to));
}

bool transform(OGRCoordinateTransformation& change, double& x, double& y) {
  const QuietErrors quiet;
  return change.Transform(1, &x, &y) != FALSE && std::isfinite(x + y);
}

}  // namespace

class ProjectedCrs::System {
 public:
  explicit System(const std::string& definition) : crs(parsed(definition)) {
    if (!crs.IsProjected())
      throw no_such_system(definition, crs.IsGeographic() ? "has degrees" : "is no projected system");
    const char* unit = nullptr;
    if (const double metres = crs.GetLinearUnits(&unit); std::abs(metres - 1) > 1e-9)
      throw no_such_system(definition, fmt::format("has the unit '{}' ({} m)", unit == nullptr ? "?" : unit, metres));
    name = crs.GetName() == nullptr ? "" : crs.GetName();
    code = code_of(crs);
    wkt = exported(crs, "WKT1_GDAL");
    if (wkt.empty()) wkt = exported(crs, "WKT2_2018");
    area = area_of(crs);
    semi_major_m = crs.GetSemiMajor(nullptr);
    const double inverse_flattening = crs.GetInvFlattening(nullptr);
    flattening = inverse_flattening > 1 ? 1 / inverse_flattening : 0;
    if (const auto plane = plane_of_crs(crs)) mercator.emplace(*plane);
    false_easting_m = crs.GetNormProjParm(SRS_PP_FALSE_EASTING, 0);
    const std::unique_ptr<OGRSpatialReference, void (*)(OGRSpatialReference*)> own(
        crs.CloneGeogCS(), [](OGRSpatialReference* r) { r->Release(); });
    if (!own) throw no_such_system(definition, "has no datum");
    own->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    to_plane = transformation(*own, crs);
    to_degrees = transformation(crs, *own);
    if (!to_plane || !to_degrees) throw no_such_system(definition, "has a projection that PROJ does not compute");
    OGRSpatialReference wgs84;
    if (wgs84.importFromEPSG(4326) == OGRERR_NONE) {
      wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
      from_wgs84 = transformation(wgs84, crs);
    }
  }

  Eigen::Vector2d by_proj(double latitude_deg, double longitude_deg) const {
    double x = longitude_deg, y = latitude_deg;
    if (!transform(*to_plane, x, y))
      throw bad_input(fmt::format("latitude {}, longitude {} lies outside {}", latitude_deg, longitude_deg, name),
                      "a position where the system is used", "Are latitude and longitude swapped?");
    return {x, y};
  }

  // Length of a radian along the meridian and the mean radius there.
  double meridian_radius_m(double latitude_deg) const {
    const double e2 = flattening * (2 - flattening), s = std::sin(radians(latitude_deg));
    return semi_major_m * (1 - e2) / std::pow(1 - e2 * s * s, 1.5);
  }
  double mean_radius_m(double latitude_deg) const {
    const double e2 = flattening * (2 - flattening), s = std::sin(radians(latitude_deg));
    return std::sqrt(meridian_radius_m(latitude_deg) * semi_major_m / std::sqrt(1 - e2 * s * s));
  }

  OGRSpatialReference crs;
  std::string name, code, wkt;
  std::optional<Area> area;
  std::optional<TransverseMercator> mercator;
  double semi_major_m = 0, flattening = 0, false_easting_m = 0;
  Transformation to_plane, to_degrees, from_wgs84;
};

ProjectedCrs::ProjectedCrs(const std::string& definition) : system_(std::make_unique<const System>(definition)) {}
ProjectedCrs::~ProjectedCrs() = default;
ProjectedCrs::ProjectedCrs(ProjectedCrs&&) noexcept = default;
ProjectedCrs& ProjectedCrs::operator=(ProjectedCrs&&) noexcept = default;

const std::string& ProjectedCrs::name() const { return system_->name; }
const std::string& ProjectedCrs::code() const { return system_->code; }
const std::string& ProjectedCrs::wkt() const { return system_->wkt; }
std::string ProjectedCrs::title() const { return code().empty() ? name() : fmt::format("{} ({})", code(), name()); }
bool ProjectedCrs::is_transverse_mercator() const { return system_->mercator.has_value(); }
double ProjectedCrs::false_easting_m() const { return system_->false_easting_m; }
const std::optional<ProjectedCrs::Area>& ProjectedCrs::area() const { return system_->area; }

PlanePoint ProjectedCrs::forward(const GeodeticPoint& point) const {
  check_geodetic(point);
  if (system_->mercator) return system_->mercator->forward(point);
  const Eigen::Vector2d at = system_->by_proj(point.latitude_deg, point.longitude_deg);
  // A step to the north shows the direction of true north and the scale.
  constexpr double step_deg = 1e-5;
  const Eigen::Vector2d north =
      system_->by_proj(point.latitude_deg + (point.latitude_deg < 89 ? step_deg : -step_deg), point.longitude_deg) - at;
  const Eigen::Vector2d up = point.latitude_deg < 89 ? north : Eigen::Vector2d(-north);
  PlanePoint plane;
  plane.easting_m = at.x();
  plane.northing_m = at.y();
  plane.convergence_deg = -degrees(std::atan2(up.x(), up.y()));
  plane.scale = up.norm() / (radians(step_deg) * system_->meridian_radius_m(point.latitude_deg));
  return plane;
}

GeodeticPoint ProjectedCrs::inverse(double easting_m, double northing_m) const {
  if (system_->mercator) return system_->mercator->inverse(easting_m, northing_m);
  double x = easting_m, y = northing_m;
  if (!std::isfinite(x + y) || !transform(*system_->to_degrees, x, y))
    throw bad_input(fmt::format("easting {} m, northing {} m lies outside {}", easting_m, northing_m, name()),
                    "coordinates of that system");
  return {y, x, 0};
}

bool ProjectedCrs::Area::holds(const GeodeticPoint& p, double margin_deg) const {
  const double width = east_deg >= west_deg ? east_deg - west_deg : east_deg - west_deg + 360;
  const double from_west = longitude_difference_deg(p.longitude_deg, west_deg + width / 2) + width / 2;
  return p.latitude_deg >= south_deg - margin_deg && p.latitude_deg <= north_deg + margin_deg &&
         from_west >= -margin_deg && from_west <= width + margin_deg;
}

bool ProjectedCrs::plausible(const GeodeticPoint& point) const {
  constexpr double margin_deg = 3, widest_deg = 12;
  if (!std::isfinite(point.latitude_deg + point.longitude_deg) || std::abs(point.latitude_deg) > 90) return false;
  if (system_->area) return system_->area->holds(point, margin_deg);
  return !system_->mercator || std::abs(longitude_difference_deg(
                                   point.longitude_deg, system_->mercator->plane().central_meridian_deg)) <= widest_deg;
}

bool ProjectedCrs::plausible(double easting_m, double northing_m) const {
  try {
    return plausible(inverse(easting_m, northing_m));
  } catch (const Error&) {
    return false;
  }
}

double ProjectedCrs::datum_shift_m(const GeodeticPoint& point) const {
  if (!system_->from_wgs84) return no_number;
  double x = point.longitude_deg, y = point.latitude_deg;
  if (!transform(*system_->from_wgs84, x, y)) return no_number;
  return (Eigen::Vector2d(x, y) - system_->by_proj(point.latitude_deg, point.longitude_deg)).norm();
}

double ProjectedCrs::ground_scale(double easting_m, double northing_m, double height_m) const {
  const auto point = inverse(easting_m, northing_m);
  const double radius = system_->mean_radius_m(point.latitude_deg);
  return forward(point).scale * radius / (radius + height_m);
}

std::string utm_code(const GeodeticPoint& point) {
  const auto utm = to_utm(point);
  return fmt::format("EPSG:{}", (utm.north ? 32600 : 32700) + utm.zone);
}

}  // namespace bole::geo
