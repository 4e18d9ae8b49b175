#include "survey/core/georeference/control_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <optional>

#include "base/error.h"
#include "base/no_number.h"
#include "base/statistics.h"
#include "cloud/table_columns.h"

namespace bole::survey {
namespace {

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool is_geodetic(const Table& t) { return t.has("latitude_deg") && t.has("longitude_deg"); }
bool is_projected(const Table& t) { return t.has("easting_m") && t.has("northing_m"); }

std::string names_of_columns(const Table& t) {
  std::string names;
  for (const auto& column : t.columns()) names += (names.empty() ? "" : ", ") + column.name;
  return names;
}

std::string row_name(const Table& t, std::size_t row) {
  const std::string name = t.has("name") ? t.text("name", row) : std::string();
  return name.empty() ? fmt::format("row {}", row + 1) : name;
}

// A column that names the zone or system of each row must hold one value.
void refuse_mixed_column(const Table& t) {
  for (const char* column : {"crs", "epsg", "zone", "utm_zone"}) {
    if (!t.has(column)) continue;
    for (std::size_t i = 1; i < t.rows(); ++i)
      if (t.text(column, i) != t.text(column, 0))
        throw bad_input(fmt::format("the control points '{}' and '{}' are of different zones ({} {} and {})",
                                    row_name(t, 0), row_name(t, i), column, t.text(column, 0), t.text(column, i)),
                        "all points in one coordinate system", "Transform them to one zone");
  }
}

void check_projected(const geo::ProjectedCrs& crs, const std::vector<double>& easting,
                     const std::vector<double>& northing, const std::vector<std::string>& names) {
  std::vector<std::size_t> given, outside;
  for (std::size_t i = 0; i < easting.size(); ++i) {
    if (!std::isfinite(easting[i] + northing[i])) continue;
    given.push_back(i);
    if (!crs.plausible(easting[i], northing[i])) outside.push_back(i);
  }
  if (outside.empty()) return;
  const std::size_t first = outside.front();
  const std::string found = fmt::format("the point '{}' with easting {:.2f} and northing {:.2f} m lies far outside {}",
                                        names[first], easting[first], northing[first], crs.title());
  if (outside.size() < given.size())
    throw bad_input(fmt::format("{}, the others do not ({} of {} points)", found, outside.size(), given.size()),
                    "all points in one zone", "Transform them to one zone, and check that none has its axes exchanged");
  const auto all = [&](auto&& plausible) { return std::ranges::all_of(given, plausible); };
  if (all([&](std::size_t i) { return crs.plausible(northing[i], easting[i]); }))
    throw bad_input(found + "; with easting and northing exchanged it lies within",
                    "the easting in easting_m and the northing in northing_m", "Exchange the two columns");
  constexpr double zone_step_m = 1e6;
  const auto short_easting = [&](std::size_t i) {
    return easting[i] - zone_step_m * std::floor(easting[i] / zone_step_m);
  };
  if (all([&](std::size_t i) { return easting[i] > 1e6 && crs.plausible(short_easting(i), northing[i]); }))
    throw bad_input(found + fmt::format("; the zone number {:.0f} stands before its easting",
                                        std::floor(easting[first] / zone_step_m)),
                    "eastings without the number of the zone",
                    "Take the first digits away, or set crs to the system with them (EPSG:4647 for UTM 32)");
  throw bad_input(found, "coordinates of that system", "Check crs and the units of the file (metres)");
}

void check_geodetic_points(const geo::ProjectedCrs& crs, const std::vector<double>& latitude,
                           const std::vector<double>& longitude, const std::vector<std::string>& names) {
  std::vector<std::size_t> given, outside;
  for (std::size_t i = 0; i < latitude.size(); ++i) {
    if (!std::isfinite(latitude[i] + longitude[i])) continue;
    given.push_back(i);
    if (!crs.plausible({latitude[i], longitude[i], 0})) outside.push_back(i);
  }
  if (outside.empty()) return;
  const std::size_t first = outside.front();
  const std::string found =
      fmt::format("the point '{}' with latitude {:.6f} and longitude {:.6f} deg lies far outside {}", names[first],
                  latitude[first], longitude[first], crs.title());
  if (std::ranges::all_of(given, [&](std::size_t i) { return crs.plausible({longitude[i], latitude[i], 0}); }))
    throw bad_input(found + "; with latitude and longitude exchanged it lies within",
                    "the latitude in latitude_deg and the longitude in longitude_deg", "Exchange the two columns");
  throw bad_input(found, "positions where the system is used", "Check crs, and the sign of western longitudes");
}

void check_datum(const geo::ProjectedCrs& crs, const geo::GeodeticPoint& point) {
  constexpr double max_shift_m = 3;
  const double shift = crs.datum_shift_m(point);
  if (shift > max_shift_m)
    throw bad_input(fmt::format("latitude and longitude are given for {}, whose datum lies {:.0f} m from that of GNSS "
                                "receivers",
                                crs.title(), shift),
                    "a system on WGS84, ETRS89 or another datum of today",
                    "Choose the system of today (UTM of ETRS89: EPSG:258xx), or transform the points and give "
                    "easting_m and northing_m");
}

// Places of targets by their names in lower case.
struct TargetPlace {
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
};

std::map<std::string, TargetPlace> target_places(const Table* targets) {
  std::map<std::string, TargetPlace> places;
  if (targets == nullptr || !targets->has("name")) return places;
  const auto x = targets->numbers("x_m"), y = targets->numbers("y_m"), z = numbers_or_nan(*targets, "z_m");
  for (std::size_t i = 0; i < targets->rows(); ++i) places[lower(targets->text("name", i))] = {{x[i], y[i], z[i]}};
  return places;
}

std::string names_of(const std::map<std::string, TargetPlace>& places) {
  std::string names;
  for (const auto& [name, place] : places) names += (names.empty() ? "" : ", ") + name;
  return names.empty() ? "no targets" : names;
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const auto& n : names) text += (text.empty() ? "'" : ", '") + n + "'";
  return text;
}

}  // namespace

geo::ProjectedCrs control_crs(const Table& control, const GeoreferenceOptions& o, const std::string& data_crs_wkt) {
  if (!o.crs.empty()) return geo::ProjectedCrs(o.crs);
  if (!data_crs_wkt.empty()) return geo::ProjectedCrs(data_crs_wkt);
  if (is_geodetic(control)) {
    const auto latitude = control.numbers("latitude_deg"), longitude = control.numbers("longitude_deg");
    for (std::size_t i = 0; i < latitude.size(); ++i)
      if (std::isfinite(latitude[i] + longitude[i]))
        return geo::ProjectedCrs(geo::utm_code({latitude[i], longitude[i], 0}));
  }
  throw bad_input("the coordinate system of the control points is not given", "an EPSG code or WKT",
                  "Set crs, for instance crs=EPSG:25832");
}

Table centre_as_table(const GeoreferenceOptions& o) {
  Table t;
  t.set("name", std::vector<std::string>{"centre"});
  if (o.easting) {
    t.set("easting_m", std::vector<double>{*o.easting});
    t.set("northing_m", std::vector<double>{*o.northing});
  } else {
    t.set("latitude_deg", std::vector<double>{o.latitude_deg.value_or(no_number)});
    t.set("longitude_deg", std::vector<double>{o.longitude_deg.value_or(no_number)});
  }
  if (o.height) t.set("height_m", std::vector<double>{*o.height});
  return t;
}

std::vector<Eigen::Vector2d> plan_coordinates(const Table& table, const geo::ProjectedCrs& crs,
                                              const std::vector<std::string>& names) {
  if (!is_projected(table) && !is_geodetic(table))
    throw bad_input("the coordinates have the columns " + names_of_columns(table),
                    "easting_m and northing_m, or latitude_deg and longitude_deg", "Rename the columns");
  const auto east = numbers_or_nan(table, "easting_m"), north = numbers_or_nan(table, "northing_m"),
             latitude = numbers_or_nan(table, "latitude_deg"), longitude = numbers_or_nan(table, "longitude_deg");
  check_projected(crs, east, north, names);
  check_geodetic_points(crs, latitude, longitude, names);
  std::vector<Eigen::Vector2d> plan;
  bool datum_checked = false;
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (std::isfinite(east[i] + north[i])) {
      plan.emplace_back(east[i], north[i]);
    } else if (std::isfinite(latitude[i] + longitude[i])) {
      const geo::GeodeticPoint at{latitude[i], longitude[i], 0};
      if (!datum_checked) check_datum(crs, at);
      datum_checked = true;
      const auto point = crs.forward(at);
      plan.emplace_back(point.easting_m, point.northing_m);
    } else {
      plan.emplace_back(no_number, no_number);
    }
  }
  return plan;
}

std::vector<ControlPoint> control_points(const Table& control, const LocalPlaces& places, const geo::ProjectedCrs& crs,
                                         const GeoreferenceOptions& o, Report& report) {
  refuse_mixed_column(control);
  const auto height = numbers_or_nan(control, "height_m"), x = numbers_or_nan(control, "x_m"),
             y = numbers_or_nan(control, "y_m"), z = numbers_or_nan(control, "z_m"),
             sd = numbers_or_nan(control, "sd_m"), height_sd = numbers_or_nan(control, "height_sd_m");
  std::vector<std::string> names;
  for (std::size_t i = 0; i < control.rows(); ++i) names.push_back(row_name(control, i));
  const auto plan = plan_coordinates(control, crs, names);
  const auto targets = target_places(places.targets);
  const auto ground = [&](double at_x, double at_y) {
    return places.dem == nullptr ? no_number : places.dem->sample(at_x, at_y);
  };

  std::vector<ControlPoint> points;
  std::vector<std::string> unplaced, unknown;
  std::map<std::string, std::size_t> taken;
  for (std::size_t i = 0; i < control.rows(); ++i) {
    ControlPoint p;
    p.name = names[i];
    p.sd_m = sd[i];
    p.height_sd_m = height_sd[i];
    if (!plan[i].allFinite()) {
      unknown.push_back(p.name);
      continue;
    }
    p.global = {plan[i].x(), plan[i].y(), height[i]};
    const auto target = targets.find(lower(p.name));
    if (std::isfinite(x[i] + y[i])) {
      p.local = {x[i], y[i], std::isfinite(z[i]) ? z[i] : ground(x[i], y[i])};
    } else if (target != targets.end()) {
      const auto& at = target->second.at;
      p.local = {at.x(), at.y(), o.height_of == ControlHeight::target ? at.z() : ground(at.x(), at.y())};
    } else {
      unplaced.push_back(p.name);
      continue;
    }
    if (const auto [before, fresh] = taken.emplace(lower(p.name), i); !fresh)
      throw bad_input(fmt::format("the control point '{}' stands in rows {} and {}", p.name, before->second + 1, i + 1),
                      "each point once", "Take one of them away, or give it another name and its x_m, y_m");
    points.push_back(std::move(p));
  }
  if (!unplaced.empty())
    report.find(Severity::look, "control_not_placed",
                fmt::format("control points {} are not used: no target has that name ({}) and the file has no x_m, y_m "
                            "for them",
                            listed(unplaced), names_of(targets)));
  if (!unknown.empty())
    report.find(Severity::look, "control_without_coordinates",
                fmt::format("control points {} are not used: their coordinates are missing", listed(unknown)));
  return points;
}

void check_distances(const std::vector<ControlPoint>& points) {
  std::vector<double> ratios;
  const ControlPoint *first = nullptr, *second = nullptr;
  double widest = -1;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      const double on_plane = (points[i].global - points[j].global).head<2>().norm(),
                   in_map = (points[i].local - points[j].local).head<2>().norm();
      if (in_map > 1) ratios.push_back(on_plane / in_map);
      if (on_plane - in_map > widest) {
        widest = on_plane - in_map;
        first = &points[i];
        second = &points[j];
      }
    }
  if (first == nullptr) return;
  const double in_map = (first->local - second->local).head<2>().norm();
  constexpr double another_zone_m = 5000;
  if (widest > another_zone_m)
    throw bad_input(fmt::format("control points '{}' and '{}' are {:.1f} km apart by their coordinates and {:.2f} m in "
                                "the map",
                                first->name, second->name, (widest + in_map) / 1000, in_map),
                    "points of one plot in one coordinate system",
                    "Are they of different zones, or does one have the zone number before its easting?");
  if (ratios.empty()) return;
  const double ratio = median(ratios);
  constexpr double foot_m = 0.3048, near = 0.02;
  for (const auto& [factor, unit] : {std::pair{1 / foot_m, "feet"}, {100.0, "centimetres"}, {1000.0, "millimetres"}})
    if (std::abs(ratio / factor - 1) < near)
      throw bad_input(fmt::format("the distances between the control points are {:.3f} times those in the map: their "
                                  "coordinates seem to be {}",
                                  ratio, unit),
                      "metres");
}

}  // namespace bole::survey
