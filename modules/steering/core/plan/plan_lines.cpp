#include "steering/core/plan/plan_lines.h"

#include <cpl_error.h>
#include <fmt/format.h>
#include <ogr_geometry.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "steering/core/guidance_line.h"
#include "steering/core/plan/plan_tables.h"
#include "steering/core/track/same_plane.h"

namespace bole::steering {

namespace {

constexpr int max_lines = 20'000;  // more are a wrong unit, not a field

using Geometry = std::unique_ptr<OGRGeometry>;

std::string text_at(const Table& t, const char* name, std::size_t row) { return t.has(name) ? t.text(name, row) : ""; }

GuidanceLine line_through(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  if (!a.allFinite() || !b.allFinite() || !((b - a).norm() > 0.1))
    throw bad_input(fmt::format("A is ({:.3f}, {:.3f}) and B is ({:.3f}, {:.3f})", a.x(), a.y(), b.x(), b.y()),
                    "two places at least 0.1 m apart");
  return {a, std::atan2((b - a).y(), (b - a).x())};
}

struct AB {
  Eigen::Vector2d a, b;
};

AB ends_of(const Table& t) {
  if (t.has("a_x_m") && t.rows() > 0)
    return {{t.numbers("a_x_m")[0], t.numbers("a_y_m")[0]}, {t.numbers("b_x_m")[0], t.numbers("b_y_m")[0]}};
  if (!t.has("x_m") || !t.has("y_m") || t.rows() < 2)
    throw bad_input(t.has("latitude_deg") && !t.has("x_m") ? "A and B have latitude and longitude"
                                                           : "the table does not hold A and B",
                    "two rows with x_m and y_m, or a_x_m, a_y_m, b_x_m, b_y_m",
                    t.has("latitude_deg") ? "Put stage geo.project before" : "Write one row for A and one for B");
  std::size_t a = 0, b = 1;
  for (std::size_t i = 0; i < t.rows(); ++i) {
    if (text_at(t, "name", i) == "A") a = i;
    if (text_at(t, "name", i) == "B") b = i;
  }
  if (a == b) throw bad_input("A and B are the same row", "a row named A and one named B");
  const auto x = t.numbers("x_m"), y = t.numbers("y_m");
  return {{x[a], y[a]}, {x[b], y[b]}};
}

// The boundary as a polygon, about `origin`.
Geometry polygon_of(const Table& t, const Eigen::Vector2d& origin) {
  const auto x = t.numbers("x_m"), y = t.numbers("y_m");
  auto ring = std::make_unique<OGRLinearRing>();
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!std::isfinite(x[i]) || !std::isfinite(y[i]))
      throw bad_input(fmt::format("corner {} of the boundary has no place", i + 1), "numbers");
    ring->addPoint(x[i] - origin.x(), y[i] - origin.y());
  }
  ring->closeRings();
  if (ring->getNumPoints() < 4)
    throw bad_input(fmt::format("a boundary of {} corners", x.size()), "three at the least");
  auto polygon = std::make_unique<OGRPolygon>();
  polygon->addRingDirectly(ring.release());
  if (!polygon->IsValid()) throw bad_input("the boundary crosses itself", "corners in their order along the field");
  if (!(polygon->get_Area() > 1e-3)) throw bad_input("the boundary encloses no area", "corners of a field");
  return polygon;
}

std::vector<Eigen::Vector2d> corners_of(const OGRLinearRing& ring, const Eigen::Vector2d& origin) {
  std::vector<Eigen::Vector2d> corners;
  for (int i = 0; i + 1 < ring.getNumPoints(); ++i)
    corners.push_back(Eigen::Vector2d(ring.getX(i), ring.getY(i)) + origin);
  return corners;
}

// The polygons of a geometry that is one or several.
std::vector<const OGRPolygon*> polygons_of(const OGRGeometry& g) {
  std::vector<const OGRPolygon*> found;
  if (wkbFlatten(g.getGeometryType()) == wkbPolygon) {
    if (!g.IsEmpty()) found.push_back(g.toPolygon());
  } else if (wkbFlatten(g.getGeometryType()) == wkbMultiPolygon ||
             wkbFlatten(g.getGeometryType()) == wkbGeometryCollection) {
    for (const auto* part : *g.toGeometryCollection())
      for (const auto* p : polygons_of(*part)) found.push_back(p);
  }
  return found;
}

// Pieces of a line inside a polygon, as intervals along it.
std::vector<std::pair<double, double>> pieces(const OGRGeometry& g, const GuidanceLine& line) {
  std::vector<std::pair<double, double>> found;
  if (wkbFlatten(g.getGeometryType()) == wkbLineString) {
    const auto* string = g.toLineString();
    if (string->getNumPoints() >= 2) {
      const double a = line.along_m({string->getX(0), string->getY(0)}),
                   b = line.along_m(
                       {string->getX(string->getNumPoints() - 1), string->getY(string->getNumPoints() - 1)});
      found.emplace_back(std::min(a, b), std::max(a, b));
    }
  } else if (OGR_GT_IsSubClassOf(wkbFlatten(g.getGeometryType()), wkbGeometryCollection)) {
    for (const auto* part : *g.toGeometryCollection())
      for (const auto& piece : pieces(*part, line)) found.push_back(piece);
  }
  std::sort(found.begin(), found.end());
  return found;
}

struct Field {
  Geometry whole, work;  // work: within the headland
  double headland_m = 0;
};

Field field_of(const Table& boundary, const Eigen::Vector2d& origin, double headland_m) {
  Field field;
  field.whole = polygon_of(boundary, origin);
  field.headland_m = headland_m;
  field.work = Geometry(headland_m > 0 ? field.whole->Buffer(-headland_m, 16) : field.whole->clone());
  if (!field.work) throw failure("the headland could not be computed", "GDAL with GEOS");
  if (polygons_of(*field.work).empty())
    throw bad_input(fmt::format("a headland of {:g} m covers the whole field", headland_m), "room for a line within it",
                    "Lower headland_passes, or look at the unit of the boundary");
  return field;
}

// Without a spacing the line through A and B alone.
void plan_within(const Field& field, const GuidanceLine& ab, std::optional<double> spacing_m, double min_length_m,
                 const Run& run, LineTable& lines, const Eigen::Vector2d& origin) {
  double min_offset = 1e300, max_offset = -1e300, min_along = 1e300, max_along = -1e300;
  for (const auto* polygon : polygons_of(*field.whole))
    for (const auto& p : corners_of(*polygon->getExteriorRing(), Eigen::Vector2d::Zero())) {
      min_offset = std::min(min_offset, ab.offset_m(p));
      max_offset = std::max(max_offset, ab.offset_m(p));
      min_along = std::min(min_along, ab.along_m(p));
      max_along = std::max(max_along, ab.along_m(p));
    }
  const double step = spacing_m.value_or(1);
  if ((max_offset - min_offset) / step > max_lines)
    throw bad_input(
        fmt::format("{:.0f} lines over a field of {:.0f} m", (max_offset - min_offset) / step, max_offset - min_offset),
        fmt::format("at most {}", max_lines), "Look at the units of the boundary and the width");
  const auto first = spacing_m ? static_cast<std::int64_t>(std::ceil(min_offset / step)) : 0,
             last = spacing_m ? static_cast<std::int64_t>(std::floor(max_offset / step)) : 0;
  for (std::int64_t k = first; k <= last; ++k) {
    run.check_cancel();
    GuidanceLine line = ab;
    line.a += static_cast<double>(k) * step * ab.left();
    const Eigen::Vector2d from = line.a + (min_along - 1) * line.along(), to = line.a + (max_along + 1) * line.along();
    OGRLineString string;
    string.addPoint(from.x(), from.y());
    string.addPoint(to.x(), to.y());
    const Geometry cut(field.work->Intersection(&string));
    if (!cut) throw failure("a line could not be cut at the boundary", "GDAL with GEOS");
    std::int64_t part = 0;
    for (const auto& [begin, end] : pieces(*cut, line))
      if (end - begin >= std::max(min_length_m, 1e-6))
        lines.add(k, ++part, line.a + begin * line.along() + origin, line.a + end * line.along() + origin);
  }
}

// Rings along the boundary: the field without its work area.
void ring_headland(const Field& field, const Eigen::Vector2d& origin, HeadlandTable& headlands) {
  if (!(field.headland_m > 0)) return;
  for (const auto* p : polygons_of(*field.whole)) headlands.add(1, "outer", corners_of(*p->getExteriorRing(), origin));
  for (const auto* p : polygons_of(*field.work)) headlands.add(1, "inner", corners_of(*p->getExteriorRing(), origin));
}

// Rectangles beyond A and beyond B, as wide as all passes.
void end_headlands(const GuidanceLine& ab, double length_m, double headland_m, const PlanOptions& o,
                   HeadlandTable& headlands) {
  if (!(headland_m > 0)) return;
  const double half = *o.width / 2, spacing_m = *o.width - o.overlap;
  const double left = o.lines_left * spacing_m + half, right = -o.lines_right * spacing_m - half;
  const auto corner = [&](double along, double offset) -> Eigen::Vector2d {
    return ab.a + along * ab.along() + offset * ab.left();
  };
  headlands.add(1, "outer", {corner(-headland_m, right), corner(0, right), corner(0, left), corner(-headland_m, left)});
  headlands.add(2, "outer",
                {corner(length_m, right), corner(length_m + headland_m, right), corner(length_m + headland_m, left),
                 corner(length_m, left)});
}

// GEOS writes its complaints to the screen; they come back as errors of ours.
class QuietGdal {
 public:
  QuietGdal() { CPLPushErrorHandler(CPLQuietErrorHandler); }
  ~QuietGdal() { CPLPopErrorHandler(); }
  QuietGdal(const QuietGdal&) = delete;
  QuietGdal& operator=(const QuietGdal&) = delete;
};

// Lines and headland of a field, in large coordinates about A so that they cost no digits.
void plan_field(const Table& boundary, const GuidanceLine& ab, std::optional<double> spacing_m, double headland_m,
                double min_length_m, const Run& run, LineTable& lines, HeadlandTable& headlands, Report& report) {
  const QuietGdal quiet;
  const Field field = field_of(boundary, ab.a, headland_m);
  plan_within(field, {Eigen::Vector2d::Zero(), ab.yaw_rad}, spacing_m, min_length_m, run, lines, ab.a);
  ring_headland(field, ab.a, headlands);
  if (lines.size() == 0)
    throw bad_input(fmt::format("no line of {:g} m fits into the boundary", min_length_m), "a field beside A and B",
                    "Look at the units of A, B and the boundary, or lower headland_passes and min_length");
  double whole = 0, work = 0;
  for (const auto* p : polygons_of(*field.whole)) whole += p->get_Area();
  for (const auto* p : polygons_of(*field.work)) work += p->get_Area();
  report.metrics["field_area"] = {whole, Unit::square_metre};
  report.metrics["headland_area"] = {whole - work, Unit::square_metre};
}

}  // namespace

LinePlan plan_lines(const Table& ab_table, const Table* boundary, const PlanOptions& o, const Run& run) {
  const auto [a, b] = ends_of(ab_table);
  const GuidanceLine ab = line_through(a, b);
  const std::optional<double> spacing = o.width ? std::optional(*o.width - o.overlap) : std::nullopt;
  const double headland = o.headland_passes * o.width.value_or(0);
  LineTable lines;
  HeadlandTable headlands;
  LinePlan plan;
  if (boundary != nullptr) {
    check_same_plane(ab_table, *boundary, "A, B and the boundary");
    plan_field(*boundary, ab, spacing, headland, o.min_length, run, lines, headlands, plan.report);
  } else {
    const double length = (b - a).norm();
    for (std::int64_t k = spacing ? -o.lines_right : 0; k <= (spacing ? o.lines_left : 0); ++k) {
      const Eigen::Vector2d shift = static_cast<double>(k) * spacing.value_or(0) * ab.left();
      lines.add(k, 1, a + shift, b + shift);
    }
    end_headlands(ab, length, headland, o, headlands);
  }
  auto& report = plan.report;
  report.counts["lines"] = static_cast<std::int64_t>(lines.size());
  report.metrics["length"] = {lines.length_m(), Unit::metre};
  report.metrics["headland"] = {headland, Unit::metre};
  report.message = fmt::format("{} lines, {:.0f} m", lines.size(), lines.length_m());
  if (spacing) report.metrics["spacing"] = {*spacing, Unit::metre};
  plan.lines = std::move(lines).table();
  plan.headlands = std::move(headlands).table();
  for (Table* t : {&plan.lines, &plan.headlands})
    for (const char* name : {"axes", "crs"})
      if (const auto it = ab_table.facts.find(name); it != ab_table.facts.end()) t->facts[name] = it->second;
  if (spacing) plan.lines.facts["row_width_m"] = number_text(*spacing);
  return plan;
}

}  // namespace bole::steering
