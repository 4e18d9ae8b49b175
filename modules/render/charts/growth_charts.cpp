#include "render/charts/growth_charts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "render/charts/columns.h"
#include "render/draw/axes.h"
#include "render/draw/furniture.h"

namespace bole::render {
namespace {

struct KindLook {
  const char *name, *words;
  Symbol symbol;
  Color color;
};
constexpr std::array<KindLook, 7> looks{{{"ingrowth", "ingrowth", Symbol::triangle, ink::good},
                                         {"gone", "gone", Symbol::cross, ink::poor},
                                         {"missed", "missed by one survey", Symbol::ring, ink::fair},
                                         {"edge", "at the edge of one survey", Symbol::triangle, ink::muted},
                                         {"outside", "outside of one survey", Symbol::square, ink::muted},
                                         {"below", "below the threshold", Symbol::disc, ink::grid},
                                         {"duplicate", "listed twice", Symbol::star, ink::primary}}};

const KindLook* look_of(const std::string& kind) {
  for (const auto& look : looks)
    if (kind.starts_with(look.name)) return &look;
  return nullptr;
}

struct GrownTree {
  Eigen::Vector2d at;
  double growth_cm = 0;
  const KindLook* look = nullptr;  // null: matched
};

struct MapContent {
  std::vector<GrownTree> trees;
  Interval x, y, growth;
  bool north_known = true;
};

constexpr double side_mm = 17, growth_legend_mm = 12;

MapContent content_of(const Table& table, bool north_known) {
  const auto x = numbers_or_nan(table, "x_m"), y = numbers_or_nan(table, "y_m"),
             growth = numbers_or_nan(table, "growth_cm");
  const auto kind = texts_or_empty(table, "kind");
  if (x.empty()) throw bad_input("the table of growth has no tree", "one at least");
  MapContent c;
  c.north_known = north_known;
  Eigen::Vector2d low(x[0], y[0]), high = low;
  double most = 0.5;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Eigen::Vector2d at(x[i], y[i]);
    low = low.cwiseMin(at);
    high = high.cwiseMax(at);
    c.trees.push_back({at, growth[i], look_of(kind[i])});
    if (std::isfinite(growth[i])) most = std::max(most, std::abs(growth[i]));
  }
  const double margin = 0.05 * std::max(1.0, (high - low).maxCoeff());
  c.x = {low.x() - margin, high.x() + margin};
  c.y = {low.y() - margin, high.y() + margin};
  c.growth = {-most, most};
  return c;
}

Frame map_frame(const MapContent& c, double width_mm) {
  const double w = width_mm - axis_space_left_mm - side_mm, h = w * std::clamp(c.y.length() / c.x.length(), 0.3, 1.3);
  return {{axis_space_left_mm, 2, axis_space_left_mm + w, 2 + h}, c.x, c.y};
}

void draw_map(Canvas& canvas, const MapContent& c, const Frame& frame, double width_mm) {
  AxesStyle axes{c.north_known ? "East (m)" : "x (m)", c.north_known ? "North (m)" : "y (m)", 7, 7};
  axes.frame = true;
  draw_grid(canvas, frame, axes);
  for (const auto& t : c.trees) {
    const auto at = frame.map(t.at.x(), t.at.y());
    if (t.look != nullptr) {
      draw_symbol(canvas, t.look->symbol, at, 2.2, t.look->color);
      continue;
    }
    const bool known = std::isfinite(t.growth_cm);
    canvas.circle(at, 1.3,
                  known ? ColorMap::diverging().at((t.growth_cm - c.growth.lo) / c.growth.length()) : ink::grid,
                  Stroke{ink::text, 0.12});
  }
  draw_axes(canvas, frame, axes);
  const double x = frame.box.x1 + 3;
  draw_color_bar(canvas, {x, 9, x + 3, 9 + std::min(40.0, frame.box.height() - 12)}, ColorMap::diverging(), c.growth,
                 "Growth (cm)");
  std::vector<LegendEntry> legend{{Symbol::ring, ink::text, "found again"}};
  for (const auto& look : looks)
    if (std::ranges::any_of(c.trees, [&](const GrownTree& t) { return t.look == &look; }))
      legend.push_back({look.symbol, look.color, look.words});
  draw_legend_row(canvas, {frame.box.x0, frame.box.y1 + axis_space_below_mm + 1}, width_mm - frame.box.x0, legend, 7);
}

struct Bar {
  double dbh = 0, growth = 0, lo = 0, hi = 0;
  Color color;
};

}  // namespace

Figure revisit_map(const Table& growth, bool north_known, double width_mm) {
  auto content = content_of(growth, north_known);
  const auto frame = map_frame(content, width_mm);
  Figure figure{"revisit_map",
                "The plot at both surveys",
                "Trees in the axes of the first survey. Filled discs: found again, coloured by the growth of their "
                "diameter.",
                width_mm,
                frame.box.y1 + axis_space_below_mm + growth_legend_mm,
                true,
                {}};
  figure.draw = [content = std::move(content), frame, width_mm](Canvas& canvas) {
    draw_map(canvas, content, frame, width_mm);
  };
  return figure;
}

Figure growth_chart(const Table& table, double width_mm) {
  const auto dbh = numbers_or_nan(table, "dbh1_cm"), growth = numbers_or_nan(table, "growth_cm"),
             lo = numbers_or_nan(table, "growth_lo_cm"), hi = numbers_or_nan(table, "growth_hi_cm");
  const auto change = texts_or_empty(table, "change");
  std::vector<Bar> bars;
  Interval x{std::numeric_limits<double>::infinity(), 0}, y{0, 0};
  for (std::size_t i = 0; i < dbh.size(); ++i) {
    if (!std::isfinite(growth[i])) continue;
    bars.push_back({dbh[i], growth[i], lo[i], hi[i],
                    change[i] == "grew"     ? ink::good
                    : change[i] == "shrank" ? ink::poor
                                            : ink::muted});
    x = {std::min(x.lo, dbh[i]), std::max(x.hi, dbh[i])};
    y = {std::min(y.lo, lo[i]), std::max(y.hi, hi[i])};
  }
  if (bars.empty()) throw bad_input("no tree was found again", "a tree with both diameters");
  const double height_mm = 0.55 * width_mm;
  const Frame frame{{axis_space_left_mm, 8, width_mm - 3, height_mm - axis_space_below_mm},
                    nice_interval(x.grown(0.03), 7),
                    nice_interval(y.grown(0.05), 6)};
  Figure figure{"growth",
                "Growth of the diameters",
                "Second less first diameter at breast height over the first, with 95 % intervals.",
                width_mm,
                height_mm,
                true,
                {}};
  figure.draw = [bars = std::move(bars), frame](Canvas& canvas) {
    const AxesStyle axes{"DBH at the first survey (cm)", "Growth (cm)", 7, 6};
    draw_grid(canvas, frame, axes);
    canvas.line(frame.map(frame.x.lo, 0), frame.map(frame.x.hi, 0), Stroke{ink::axis, 0.25});
    for (const auto& b : bars) {
      canvas.line(frame.map(b.dbh, b.lo), frame.map(b.dbh, b.hi), Stroke{b.color.with_alpha(0.6), 0.25});
      canvas.circle(frame.map(b.dbh, b.growth), 0.8, b.color);
    }
    draw_axes(canvas, frame, axes);
    draw_legend_row(canvas, {frame.box.x0, 1}, frame.box.width(),
                    {{Symbol::disc, ink::good, "grew"},
                     {Symbol::disc, ink::muted, "not told from none"},
                     {Symbol::disc, ink::poor, "thinner than before"}},
                    7);
  };
  return figure;
}

}  // namespace bole::render
