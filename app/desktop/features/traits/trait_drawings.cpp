#include "features/traits/trait_drawings.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/angles.h"
#include "base/transform.h"
#include "render/charts/columns.h"

namespace bole::desktop {
namespace {

constexpr int ring_sides = 32;
constexpr double trait_tick_m = 0.02;

double first_of(const Table& table, const char* column, double factor) {
  const auto values = render::numbers_or_nan(table, column);
  return values.empty() ? std::numeric_limits<double>::quiet_NaN() : factor * values.front();
}
double millimetres_of(const Table& table, const char* column) { return first_of(table, column, 1e-3); }

// "0.1 0.2 0.3"
std::optional<Eigen::Vector3d> vector_fact(const Facts& facts, const char* key) {
  const auto it = facts.find(key);
  if (it == facts.end()) return {};
  Eigen::Vector3d v;
  const char *at = it->second.data(), *end = at + it->second.size();
  for (int axis = 0; axis < 3; ++axis) {
    while (at < end && *at == ' ') ++at;
    const auto read = std::from_chars(at, end, v[axis]);
    if (read.ec != std::errc{}) return {};
    at = read.ptr;
  }
  return v.allFinite() ? std::optional(v) : std::nullopt;
}

std::optional<Eigen::Vector3d> base_of(const Survey& survey) {
  const auto& t = *survey.traits;
  const Eigen::Vector3d base(first_of(t, "base_x_m", 1), first_of(t, "base_y_m", 1), first_of(t, "base_z_m", 1));
  if (base.allFinite()) return base;
  if (auto fact = vector_fact(t.facts, "plant_base_m")) return fact;
  return survey.points ? vector_fact(survey.points->facts, "plant_base_m") : std::nullopt;
}

// The axis at a height above the soil, between two sections; nothing beyond them.
std::optional<Eigen::Vector3d> on_axis(const std::vector<double>& heights_m, const std::vector<Eigen::Vector3d>& axis,
                                       double height_m) {
  for (std::size_t i = 1; i < axis.size(); ++i) {
    const double a = heights_m[i - 1], b = heights_m[i];
    if (height_m < std::min(a, b) || height_m > std::max(a, b) || a == b) continue;
    return Eigen::Vector3d(axis[i - 1] + (height_m - a) / (b - a) * (axis[i] - axis[i - 1]));
  }
  return {};
}

// Corners of the rectangle of the breadth around its centre in plan.
std::vector<Eigen::Vector3d> rectangle_of(const Table& t, const Eigen::Vector3d& base) {
  const Eigen::Vector3d centre(first_of(t, "breadth_x_m", 1), first_of(t, "breadth_y_m", 1), base.z());
  const double angle = first_of(t, "breadth_angle_deg", rad_per_deg), length = millimetres_of(t, "breadth_length_mm"),
               width = millimetres_of(t, "breadth_width_mm");
  if (!centre.allFinite() || !std::isfinite(angle + length + width)) return {};
  const Eigen::Vector3d along(std::cos(angle), std::sin(angle), 0), across(-along.y(), along.x(), 0);
  std::vector<Eigen::Vector3d> corners;
  for (const auto& [a, b] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
    corners.emplace_back(centre + a * length / 2 * along + b * width / 2 * across);
  return corners;
}

std::string millimetres(double metres, int decimals) {
  return QString::number(1000 * metres, 'f', decimals).toStdString() + " mm";
}

SceneDrawing height_drawing(const TraitPlaces& places, double height_m) {
  const Eigen::Vector3d u = places.up.unitOrthogonal(), v = places.up.cross(u);
  const Eigen::Vector3d top = *places.base + height_m * places.up;
  SceneDrawing d;
  d.id = "height";
  d.lines = {{*places.base, top}};
  for (const auto& p : {*places.base, top})
    for (const auto& side : {u, v}) d.lines.push_back({p - trait_tick_m * side, p + trait_tick_m * side});
  d.label = millimetres(height_m, 1);
  d.label_at = top;
  return d;
}

SceneDrawing stem_drawing(const TraitPlaces& places, double diameter_m) {
  const Eigen::Vector3d u = places.up.unitOrthogonal(), v = places.up.cross(u);
  SceneDrawing d;
  d.id = "stem";
  std::vector<Eigen::Vector3d> ring;
  for (int i = 0; i <= ring_sides; ++i) {
    const double a = 2 * std::numbers::pi * i / ring_sides;
    ring.emplace_back(*places.stem + diameter_m / 2 * (std::cos(a) * u + std::sin(a) * v));
  }
  // A few millimetres are hard to see: a line leads to them.
  d.lines = {ring, {*places.stem + diameter_m / 2 * u, *places.stem + (diameter_m / 2 + trait_tick_m) * u}};
  d.label = "Ø " + millimetres(diameter_m, 2);
  d.label_at = d.lines[1].back();
  return d;
}

}  // namespace

TraitPlaces trait_places(const Survey& survey) {
  TraitPlaces places;
  if (!survey.traits || survey.traits->rows() == 0) return places;
  const auto& t = *survey.traits;
  if (survey.points)
    if (const auto up = vector_fact(survey.points->facts, "plant_up"); up && up->norm() > 0.5)
      places.up = up->normalized();
  places.base = base_of(survey);
  if (places.base) places.rectangle = rectangle_of(t, *places.base);
  if (!survey.stem || survey.stem->rows() == 0) return places;
  const auto x = render::numbers_or_nan(*survey.stem, "x_m"), y = render::numbers_or_nan(*survey.stem, "y_m"),
             z = render::numbers_or_nan(*survey.stem, "z_m");
  auto heights_m = render::numbers_or_nan(*survey.stem, "height_mm");
  for (auto& h : heights_m) h /= 1000;
  // The table has the axes of the plant: z up, the origin in the base.
  if (!places.base) return places;
  const Eigen::Matrix3d up_from_world = rotation_between(places.up, Eigen::Vector3d::UnitZ());
  for (std::size_t i = 0; i < x.size(); ++i)
    places.axis.emplace_back(*places.base + up_from_world.transpose() * Eigen::Vector3d(x[i], y[i], z[i]));
  if (std::ranges::any_of(places.axis, [](const auto& p) { return !p.allFinite(); })) places.axis.clear();
  if (!places.axis.empty()) places.stem = on_axis(heights_m, places.axis, millimetres_of(t, "stem_height_mm"));
  return places;
}

std::vector<SceneDrawing> trait_drawings(const Survey& survey) {
  std::vector<SceneDrawing> drawings;
  if (!survey.traits || survey.traits->rows() == 0) return drawings;
  const auto& t = *survey.traits;
  const auto places = trait_places(survey);
  if (const double height = millimetres_of(t, "height_mm"); places.base && std::isfinite(height))
    drawings.push_back(height_drawing(places, height));
  if (!places.rectangle.empty()) {
    SceneDrawing d;
    d.id = "breadth";
    auto outline = places.rectangle;
    outline.push_back(outline.front());
    d.lines = {outline};
    d.label = QString::number(first_of(t, "breadth_length_mm", 1), 'f', 1).toStdString() + " × " +
              millimetres(millimetres_of(t, "breadth_width_mm"), 1);
    d.label_at = places.rectangle.front();
    drawings.push_back(std::move(d));
  }
  if (places.axis.size() > 1) {
    SceneDrawing d;
    d.id = "axis";
    d.lines = {places.axis};
    drawings.push_back(std::move(d));
  }
  if (const double diameter = millimetres_of(t, "stem_diameter_mm"); places.stem && std::isfinite(diameter))
    drawings.push_back(stem_drawing(places, diameter));
  return drawings;
}

std::shared_ptr<const Table> trait_rows(const Table* traits) {
  if (traits == nullptr || traits->rows() == 0) return nullptr;
  std::vector<std::string> names, units;
  std::vector<double> value, from, to;
  for (const auto& column : traits->columns()) {
    const auto unit_at = column.name.rfind('_');
    if (unit_at == std::string::npos || std::holds_alternative<std::vector<std::string>>(column.values)) continue;
    const std::string stem = column.name.substr(0, unit_at), unit = column.name.substr(unit_at + 1);
    if (!traits->has(stem + "_lo_" + unit) || !traits->has(stem + "_hi_" + unit)) continue;
    std::string words = stem;
    std::ranges::replace(words, '_', ' ');
    names.push_back(words);
    units.push_back(unit);
    value.push_back(traits->numbers(column.name).front());
    from.push_back(traits->numbers(stem + "_lo_" + unit).front());
    to.push_back(traits->numbers(stem + "_hi_" + unit).front());
  }
  auto rows = std::make_shared<Table>();
  rows->set("trait", names);
  rows->set("value", value);
  rows->set("from", from);
  rows->set("to", to);
  rows->set("unit", units);
  return rows;
}

}  // namespace bole::desktop
