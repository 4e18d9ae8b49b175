#include "render/scene/measurement.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "base/angles.h"
#include "base/error.h"

namespace bole::render {
namespace {

using Json = nlohmann::ordered_json;
using Kind = Measurement::Kind;

constexpr std::array kinds{Kind::point, Kind::distance, Kind::angle, Kind::ring};
constexpr int ring_sides = 64;
constexpr std::size_t max_measurements = 100'000;

double angle_deg(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b)) * deg_per_rad;
}

Eigen::Vector3d flat(const Eigen::Vector3d& v) { return {v.x(), v.y(), 0}; }

Kind kind_from(const Json& value, const std::string& where) {
  for (const auto kind : kinds)
    if (value == std::string(kind_name(kind))) return kind;
  throw bad_input(where + " is of the kind " + value.dump(), "point, distance, angle or ring");
}

double number_from(const Json& value, const std::string& where) {
  const double number = value.is_number() ? value.get<double>() : std::nan("");
  if (!std::isfinite(number)) throw bad_input(where + " holds " + value.dump(), "a number");
  return number;
}

double metres_from(const Json& value, const std::string& where) {
  const double metres = number_from(value, where);
  if (std::abs(metres) > 1e9) throw bad_input(where + " holds " + value.dump(), "metres");
  return metres;
}

Measurement measurement_from(const Json& object, const std::string& where) {
  if (!object.is_object() || !object.contains("kind") || !object.contains("points") || !object["points"].is_array())
    throw bad_input(where + " is " + object.dump(), R"(an object with "kind" and "points")");
  Measurement m;
  m.kind = kind_from(object["kind"], where);
  m.name = object.contains("name") && object["name"].is_string() ? object["name"].get<std::string>() : "";
  if (static_cast<int>(object["points"].size()) != points_needed(m.kind))
    throw bad_input(fmt::format("{} has {} points", where, object["points"].size()),
                    fmt::format("{} for the kind {}", points_needed(m.kind), kind_name(m.kind)));
  for (const auto& place : object["points"]) {
    if (!place.is_array() || place.size() != 3)
      throw bad_input(where + " has a point " + place.dump(), "[x, y, z] in metres");
    m.points.emplace_back(metres_from(place[0], where), metres_from(place[1], where), metres_from(place[2], where));
  }
  const auto fact = [&](const char* key, std::optional<double>& into, auto read) {
    if (object.contains(key)) into = read(object[key], where);
  };
  fact("height_above_ground_m", m.height_above_ground_m, metres_from);
  fact("range_m", m.range_m, metres_from);
  fact("time_s", m.time_s, number_from);  // since 1970 in most captures: beyond any length
  return m;
}

std::string csv_text(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

std::string_view kind_name(Kind kind) {
  constexpr std::array<std::string_view, 4> names{"point", "distance", "angle", "ring"};
  return names[static_cast<std::size_t>(kind)];
}

int points_needed(Kind kind) {
  constexpr std::array needed{1, 2, 3, 3};
  return needed[static_cast<std::size_t>(kind)];
}

std::optional<PlanRing> ring_through(const std::vector<Eigen::Vector3d>& points) {
  if (points.size() != 3) return {};
  // Relative to the first: projected coordinates are large.
  const Eigen::Vector2d b = (points[1] - points[0]).head<2>(), c = (points[2] - points[0]).head<2>();
  const double twice_area = 2 * (b.x() * c.y() - b.y() * c.x());
  if (std::abs(twice_area) < 1e-6 * std::max(b.squaredNorm(), c.squaredNorm())) return {};
  const Eigen::Vector2d centre(c.y() * b.squaredNorm() - b.y() * c.squaredNorm(),
                               b.x() * c.squaredNorm() - c.x() * b.squaredNorm());
  const Eigen::Vector2d off = centre / twice_area;
  return PlanRing{points[0].head<2>() + off, off.norm(), (points[0].z() + points[1].z() + points[2].z()) / 3};
}

std::vector<MeasuredValue> values_of(const Measurement& m) {
  std::vector<MeasuredValue> values;
  const auto& p = m.points;
  if (static_cast<int>(p.size()) != points_needed(m.kind)) return values;
  switch (m.kind) {
    case Kind::point:
      values = {{"x", "m", p[0].x()}, {"y", "m", p[0].y()}, {"z", "m", p[0].z()}};
      if (m.height_above_ground_m) values.push_back({"height above ground", "m", *m.height_above_ground_m});
      if (m.range_m) values.push_back({"range", "m", *m.range_m});
      if (m.time_s) values.push_back({"time", "s", *m.time_s});
      break;
    case Kind::distance: {
      const Eigen::Vector3d d = p[1] - p[0];
      const double level = d.head<2>().norm();
      values = {{"distance", "m", d.norm()},
                {"horizontal", "m", level},
                {"vertical", "m", d.z()},
                {"slope", "°", std::atan2(d.z(), level) * deg_per_rad, 1}};
      break;
    }
    case Kind::angle: {
      const Eigen::Vector3d a = p[0] - p[1], b = p[2] - p[1];
      values = {{"angle", "°", angle_deg(a, b), 1}, {"angle in plan", "°", angle_deg(flat(a), flat(b)), 1}};
      break;
    }
    case Kind::ring:
      if (const auto ring = ring_through(p))
        values = {{"diameter", "cm", 200 * ring->radius_m, 1},
                  {"girth", "cm", 200 * std::numbers::pi * ring->radius_m, 1},
                  {"centre x", "m", ring->centre.x()},
                  {"centre y", "m", ring->centre.y()},
                  {"z", "m", ring->z_m}};
  }
  return values;
}

std::string label_of(const Measurement& m) {
  const auto values = values_of(m);
  const std::string name = m.name.empty() ? "" : m.name + "  ";
  if (values.empty()) return name + "on one line";
  if (m.kind == Kind::point)
    return name + (m.height_above_ground_m ? fmt::format("{:.2f} m above ground", *m.height_above_ground_m)
                                           : fmt::format("z {:.2f} m", m.points[0].z()));
  if (m.kind == Kind::distance)
    return fmt::format("{}{:.3f} m  ↔ {:.3f}  ↕ {:.3f}", name, values[0].value, values[1].value, values[2].value);
  return fmt::format("{}{:.{}f} {}", name, values[0].value, values[0].decimals, values[0].unit);
}

std::vector<std::vector<Eigen::Vector3d>> lines_of(const Measurement& m) {
  if (m.kind == Kind::point) return {};
  const auto ring = m.kind == Kind::ring ? ring_through(m.points) : std::nullopt;
  if (!ring) return {m.points};
  std::vector<Eigen::Vector3d> round;
  for (int k = 0; k <= ring_sides; ++k) {
    const double a = 2 * std::numbers::pi * k / ring_sides;
    round.emplace_back(ring->centre.x() + ring->radius_m * std::cos(a), ring->centre.y() + ring->radius_m * std::sin(a),
                       ring->z_m);
  }
  return {round};
}

Measurement point_measurement(const PointCloud& cloud, std::uint32_t index) {
  Measurement m;
  m.points = {exact_position(cloud, index)};
  const auto fact = [&](std::string_view array) -> std::optional<double> {
    if (!cloud.has(array)) return {};
    const double value = column_value(cloud.column(array), index);
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
  };
  m.height_above_ground_m = fact("height_above_ground");
  m.range_m = fact("range");
  m.time_s = fact("time");
  return m;
}

std::string measurements_json(const std::vector<Measurement>& measurements) {
  Json root;
  root["measurements"] = Json::array();
  for (const auto& m : measurements) {
    Json object{{"name", m.name}, {"kind", std::string(kind_name(m.kind))}, {"points", Json::array()}};
    for (const auto& p : m.points) object["points"].push_back({p.x(), p.y(), p.z()});
    if (m.height_above_ground_m) object["height_above_ground_m"] = *m.height_above_ground_m;
    if (m.range_m) object["range_m"] = *m.range_m;
    if (m.time_s) object["time_s"] = *m.time_s;
    root["measurements"].push_back(std::move(object));
  }
  return root.dump(1) + "\n";
}

std::vector<Measurement> parse_measurements(std::string_view json) {
  const auto root = Json::parse(json, nullptr, false);
  if (root.is_discarded() || !root.is_object() || !root.contains("measurements") || !root["measurements"].is_array())
    throw bad_input("the measurements are no JSON object with a list", R"({"measurements": [...]})");
  const auto& list = root["measurements"];
  if (list.size() > max_measurements)
    throw bad_input(fmt::format("{} measurements", list.size()), fmt::format("at most {}", max_measurements));
  std::vector<Measurement> measurements;
  for (std::size_t i = 0; i < list.size(); ++i)
    measurements.push_back(measurement_from(list[i], fmt::format("measurement {}", i + 1)));
  return measurements;
}

std::string measurements_csv(const std::vector<Measurement>& measurements) {
  std::string csv = "name,kind,quantity,value,unit,places\n";
  for (const auto& m : measurements) {
    std::string places;
    for (const auto& p : m.points)
      places += fmt::format("{}{:.4f} {:.4f} {:.4f}", places.empty() ? "" : "; ", p.x(), p.y(), p.z());
    for (const auto& v : values_of(m))
      csv += fmt::format("{},{},{},{:.{}f},{},{}\n", csv_text(m.name), kind_name(m.kind), v.name, v.value,
                         v.decimals + 1, v.unit, places);
  }
  return csv;
}

}  // namespace bole::render
