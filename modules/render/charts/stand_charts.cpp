#include "render/charts/stand_charts.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "cloud/stem_rows.h"
#include "render/charts/columns.h"
#include "render/draw/axes.h"
#include "render/draw/furniture.h"

namespace bole::render {
namespace {

struct StandTree {
  double dbh_cm = 0, height_m = 0;
  bool seen = true;
  Color color;
};

// Naslund: h = breast height + d^2 / (a + b d)^2
struct Curve {
  double breast_height_m = 1.3, a = 0, b = 0, min_dbh_cm = 0, max_dbh_cm = 0;
  double height_m(double d) const { return breast_height_m + d * d / ((a + b * d) * (a + b * d)); }
};

std::vector<StandTree> trees_of(const Table& stems) {
  const auto dbh = numbers_or_nan(stems, "dbh_cm"), height = known_heights(stems),
             seen = numbers_or_nan(stems, "height_seen");
  const auto quality = texts_or_empty(stems, "quality");
  std::vector<StandTree> trees;
  for (std::size_t i = 0; i < stems.rows(); ++i)
    if (std::isfinite(dbh[i] + height[i]))
      trees.push_back({dbh[i], height[i], seen[i] != 0, quality_color(quality[i])});
  return trees;
}

std::optional<Curve> curve_of(const Table* table) {
  if (table == nullptr || table->rows() == 0) return {};
  const auto value = [&](const char* column) { return numbers_or_nan(*table, column)[0]; };
  return Curve{value("breast_height_m"), value("a"), value("b"), value("min_dbh_cm"), value("max_dbh_cm")};
}

Frame frame_of(const Canvas& canvas, const Interval& x, const Interval& y) {
  return {{axis_space_left_mm, 3, canvas.width_mm() - 3, canvas.height_mm() - axis_space_below_mm - 6}, x, y};
}

void draw_tree_heights(Canvas& canvas, const std::vector<StandTree>& trees, const std::optional<Curve>& curve) {
  double max_x = 10, max_y = 5;
  for (const auto& t : trees) max_x = std::max(max_x, t.dbh_cm), max_y = std::max(max_y, t.height_m);
  const Frame frame = frame_of(canvas, nice_interval({0, 1.05 * max_x}, 6), nice_interval({0, 1.05 * max_y}, 5));
  AxesStyle axes{"DBH (cm)", "Height (m)"};
  axes.y_ticks = 5;
  draw_grid(canvas, frame, axes);
  if (curve) {
    std::vector<Eigen::Vector2d> line;
    for (int i = 0; i <= 60; ++i) {
      const double d = std::lerp(curve->min_dbh_cm, curve->max_dbh_cm, i / 60.0);
      if (const double h = curve->height_m(d); std::isfinite(h)) line.push_back(frame.map(d, h));
    }
    if (line.size() > 1) canvas.polyline(line, Stroke{ink::text, 0.35});
  }
  bool seen = false, bounds = false;
  for (const auto& t : trees) {
    canvas.circle(frame.map(t.dbh_cm, t.height_m), 0.85, t.seen ? t.color.with_alpha(0.85) : ink::paper,
                  Stroke{t.seen ? ink::paper : t.color, t.seen ? 0.1 : 0.25});
    (t.seen ? seen : bounds) = true;
  }
  draw_axes(canvas, frame, axes);
  std::vector<LegendEntry> entries;
  if (seen) entries.push_back({Symbol::disc, ink::good, "top seen"});
  if (bounds) entries.push_back({Symbol::ring, ink::good, "lower bound"});
  if (curve) entries.push_back({Symbol::line, ink::text, "height curve"});
  draw_legend_row(canvas, {frame.box.x0, canvas.height_mm() - 5}, frame.box.width(), entries);
}

struct Section {
  double height_m = 0, diameter_cm = 0;
};

struct StemCurve {
  std::vector<Section> sections;  // by height
  Color color;
};

std::vector<StemCurve> curves_of(const Table& stems, const Table& table) {
  std::map<std::int64_t, Color> colors;
  const auto quality = texts_or_empty(stems, "quality");
  const auto ids = stems.integers("tree_id");
  for (std::size_t i = 0; i < ids.size(); ++i) colors[ids[i]] = quality_color(quality[i]);
  std::map<std::int64_t, StemCurve> by_tree;
  const auto tree = table.integers("tree_id");
  const auto height = numbers_or_nan(table, "height_m"), diameter = numbers_or_nan(table, "diameter_cm"),
             used = numbers_or_nan(table, table.has("curve") ? "curve" : "used");
  for (std::size_t i = 0; i < tree.size(); ++i) {
    const auto color = colors.find(tree[i]);
    if (color == colors.end() || !(used[i] > 0) || !std::isfinite(height[i] + diameter[i])) continue;
    by_tree[tree[i]].sections.push_back({height[i], diameter[i]});
    by_tree[tree[i]].color = color->second;
  }
  std::vector<StemCurve> curves;
  for (auto& [id, curve] : by_tree) {
    std::ranges::sort(curve.sections, {}, &Section::height_m);
    if (curve.sections.size() >= 2) curves.push_back(std::move(curve));
  }
  return curves;
}

void draw_taper(Canvas& canvas, const std::vector<StemCurve>& curves) {
  double max_x = 3, max_y = 10;
  for (const auto& c : curves)
    for (const auto& s : c.sections) max_x = std::max(max_x, s.height_m), max_y = std::max(max_y, s.diameter_cm);
  const Frame frame = frame_of(canvas, nice_interval({0, 1.02 * max_x}, 6), nice_interval({0, 1.05 * max_y}, 5));
  AxesStyle axes{"Height above ground (m)", "Diameter (cm)"};
  axes.y_ticks = 5;
  draw_grid(canvas, frame, axes);
  for (const auto& c : curves) {
    std::vector<Eigen::Vector2d> line;
    for (const auto& s : c.sections) line.push_back(frame.map(s.height_m, s.diameter_cm));
    canvas.polyline(line, Stroke{c.color.with_alpha(0.7), 0.28});
    canvas.dots(line, 0.55, c.color.with_alpha(0.7));
  }
  draw_axes(canvas, frame, axes);
  draw_legend_row(
      canvas, {frame.box.x0, canvas.height_mm() - 5}, frame.box.width(),
      {{Symbol::line, ink::good, "good"}, {Symbol::line, ink::fair, "fair"}, {Symbol::line, ink::poor, "poor"}});
}

}  // namespace

bool has_heights(const Table& stems) { return !trees_of(stems).empty(); }

Figure height_diameter(const Table& stems, const Table* curve, double width_mm) {
  Figure figure{"height_diameter",
                "Heights over diameters",
                "Height of each tree over its diameter at breast height, in the colours of quality; rings are lower "
                "bounds: the top was not seen.",
                width_mm,
                0.72 * width_mm,
                true,
                {}};
  const auto fitted = curve_of(curve);
  if (fitted) figure.caption += " Line: the height curve, over the diameters that it was fitted to.";
  figure.draw = [trees = trees_of(stems), fitted](Canvas& canvas) { draw_tree_heights(canvas, trees, fitted); };
  return figure;
}

bool has_stem_curves(const Table& stems, const Table& sections) {
  return stems.has("tree_id") && sections.has("tree_id") && !curves_of(stems, sections).empty();
}

Figure taper_curves(const Table& stems, const Table& sections, double width_mm) {
  Figure figure{"taper",
                "Taper of the stems",
                "Fitted diameters along each stem, in the colours of quality: a stem becomes thinner upwards. A line "
                "that jumps or grows deserves a look.",
                width_mm,
                0.72 * width_mm,
                true,
                {}};
  figure.draw = [curves = curves_of(stems, sections)](Canvas& canvas) { draw_taper(canvas, curves); };
  return figure;
}

}  // namespace bole::render
