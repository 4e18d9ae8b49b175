#include "cloud/plot_area.h"

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "base/error.h"
#include "base/option_text.h"

namespace bole {
inline namespace cloud {
namespace {

using Eigen::Vector2d;
using Shape = PlotArea::Shape;

constexpr std::array<std::pair<Shape, std::string_view>, 4> shape_names{
    {{Shape::none, "none"}, {Shape::rectangle, "rectangle"}, {Shape::circle, "circle"}, {Shape::polygon, "polygon"}}};

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

// Twice the area, positive when the vertices run anticlockwise. Relative to the first vertex, so that map coordinates
// of millions of metres lose nothing.
double twice_signed_area(const std::vector<Vector2d>& v) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < v.size(); ++i) sum += cross(v[i] - v[0], v[i + 1] - v[0]);
  return sum;
}

Vector2d centroid(const std::vector<Vector2d>& v) {
  Vector2d sum = Vector2d::Zero();
  for (std::size_t i = 1; i + 1 < v.size(); ++i)
    sum += cross(v[i] - v[0], v[i + 1] - v[0]) * ((v[i] - v[0]) + (v[i + 1] - v[0])) / 3;
  return v[0] + sum / twice_signed_area(v);
}

bool on_segment(const Vector2d& p, const Vector2d& a, const Vector2d& b) {
  const Vector2d ab = b - a, ap = p - a;
  const double tolerance = 1e-9 * (1 + ab.norm());
  return std::abs(cross(ab, ap)) <= tolerance * std::max(1e-12, ab.norm()) && ap.dot(ab) >= 0 &&
         ap.dot(ab) <= ab.squaredNorm();
}

bool in_polygon(const Vector2d& p, const std::vector<Vector2d>& v) {
  bool inside = false;
  for (std::size_t i = 0, j = v.size() - 1; i < v.size(); j = i++) {
    if (on_segment(p, v[j], v[i])) return true;
    if ((v[i].y() > p.y()) != (v[j].y() > p.y()) &&
        p.x() < v[i].x() + (p.y() - v[i].y()) * (v[j].x() - v[i].x()) / (v[j].y() - v[i].y()))
      inside = !inside;
  }
  return inside;
}

bool segments_cross(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
  const double c_side = cross(b - a, c - a), d_side = cross(b - a, d - a), a_side = cross(d - c, a - c),
               b_side = cross(d - c, b - c);
  return c_side * d_side < 0 && a_side * b_side < 0;
}

bool crosses_itself(const std::vector<Vector2d>& v) {
  const std::size_t n = v.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 2; j < n; ++j)
      if (segments_cross(v[i], v[(i + 1) % n], v[j], v[(j + 1) % n])) return true;
  return false;
}

// Into the axes of a rectangle: x across, y along its bearing.
Vector2d along_bearing(const Vector2d& d, double bearing_rad) {
  const double c = std::cos(bearing_rad), s = std::sin(bearing_rad);
  return {c * d.x() - s * d.y(), s * d.x() + c * d.y()};
}

double fact_number(const Table& table, const std::string& name) {
  const auto it = table.facts.find(name);
  if (it == table.facts.end())
    throw bad_input("a table without '" + name + "' in its facts", "the plot of a stage survey.plot");
  if (const auto value = number_from_text(it->second)) return *value;
  throw bad_input("the fact '" + name + "' of the plot is '" + it->second + "'", "a number");
}

}  // namespace

double PlotArea::area_m2() const {
  switch (shape) {
    case Shape::rectangle:
      return width_m * length_m;
    case Shape::circle:
      return std::numbers::pi / 4 * width_m * width_m;
    case Shape::polygon:
      return std::abs(twice_signed_area(vertices)) / 2;
    default:
      return std::nan("");
  }
}

bool PlotArea::contains(const Vector2d& point) const {
  const Vector2d d = point - centre;
  switch (shape) {
    case Shape::rectangle: {
      const Vector2d q = along_bearing(d, bearing_rad);
      return std::abs(q.x()) <= width_m / 2 && std::abs(q.y()) <= length_m / 2;
    }
    case Shape::circle:
      return d.squaredNorm() <= width_m * width_m / 4;
    case Shape::polygon:
      return in_polygon(point, vertices);
    default:
      return true;
  }
}

std::vector<Vector2d> PlotArea::outline() const {
  std::vector<Vector2d> points = vertices;
  if (shape == Shape::rectangle)
    for (const auto& [sx, sy] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
      points.emplace_back(centre + along_bearing({sx * width_m / 2, sy * length_m / 2}, -bearing_rad));
  if (shape == Shape::circle)
    for (int i = 0; i < 180; ++i)
      points.emplace_back(
          centre + width_m / 2 * Vector2d(std::cos(i * std::numbers::pi / 90), std::sin(i * std::numbers::pi / 90)));
  return points;
}

PlotArea rectangle_area(const Vector2d& centre, double width_m, double length_m, double bearing_rad) {
  return {Shape::rectangle, centre, width_m, length_m, bearing_rad, {}};
}

PlotArea circle_area(const Vector2d& centre, double radius_m) {
  return {Shape::circle, centre, 2 * radius_m, 2 * radius_m, 0, {}};
}

PlotArea polygon_area(std::vector<Vector2d> vertices) {
  if (vertices.size() > 1 && vertices.front() == vertices.back()) vertices.pop_back();
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (!vertices[i].allFinite())
      throw bad_input("vertex " + std::to_string(i + 1) + " of the plot boundary has no position",
                      "x_m and y_m in every row");
  if (vertices.size() < 3 || twice_signed_area(vertices) == 0)
    throw bad_input("a plot boundary of " + std::to_string(vertices.size()) + " vertices that encloses nothing",
                    "at least three that do not lie on one line");
  if (crosses_itself(vertices))
    throw bad_input("the plot boundary crosses itself", "vertices in order around the plot");
  const Vector2d centre = centroid(vertices);
  return {Shape::polygon, centre, 0, 0, 0, std::move(vertices)};
}

std::string describe(const PlotArea& area) {
  switch (area.shape) {
    case PlotArea::Shape::rectangle:
      return number_text(area.width_m) + " m × " + number_text(area.length_m) + " m";
    case PlotArea::Shape::circle:
      return "circle of radius " + number_text(area.width_m / 2) + " m";
    case PlotArea::Shape::polygon:
      return "polygon of " + std::to_string(area.vertices.size()) + " vertices";
    default:
      return "no boundary";
  }
}

Table to_table(const CountingRule& rule) {
  Table t;
  std::vector<double> x, y;
  for (const auto& p : rule.area.outline()) x.push_back(p.x()), y.push_back(p.y());
  t.set("x_m", x), t.set("y_m", y);
  for (const auto& [shape, name] : shape_names)
    if (shape == rule.area.shape) t.facts["shape"] = std::string(name);
  const auto put = [&t](const char* name, double value) { t.facts[name] = number_text(value); };
  put("centre_x_m", rule.area.centre.x()), put("centre_y_m", rule.area.centre.y());
  put("width_m", rule.area.width_m), put("length_m", rule.area.length_m), put("bearing_rad", rule.area.bearing_rad);
  put("min_dbh_cm", rule.min_dbh_cm);
  return t;
}

CountingRule counting_rule(const Table& table) {
  CountingRule rule;
  rule.min_dbh_cm = fact_number(table, "min_dbh_cm");
  auto& area = rule.area;
  area.centre = {fact_number(table, "centre_x_m"), fact_number(table, "centre_y_m")};
  area.width_m = fact_number(table, "width_m"), area.length_m = fact_number(table, "length_m");
  area.bearing_rad = fact_number(table, "bearing_rad");
  for (const auto& [shape, name] : shape_names)
    if (table.facts.at("shape") == name) area.shape = shape;
  if (area.shape == Shape::polygon) {
    const auto x = table.numbers("x_m"), y = table.numbers("y_m");
    for (std::size_t i = 0; i < x.size(); ++i) area.vertices.emplace_back(x[i], y[i]);
  }
  return rule;
}

}  // namespace cloud
}  // namespace bole
