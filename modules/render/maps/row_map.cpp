#include "render/maps/row_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "render/draw/axes.h"
#include "render/draw/furniture.h"

namespace bole::render {
namespace {

using Points = std::vector<Eigen::Vector2d>;

struct Line {
  std::string id;
  Points vertices;
};

struct Content {
  std::vector<Line> lines;
  Points present, missing, strays;
  bool north_known = true;
};

constexpr double row_margin_left = axis_space_left_mm, row_margin_right = 2, row_margin_top = 2, row_margin_below = 11,
                 row_furniture_mm = 12;

Points points_of(const Table& table) {
  const auto x = table.numbers("x_m"), y = table.numbers("y_m");
  Points points;
  for (std::size_t i = 0; i < x.size(); ++i) points.emplace_back(x[i], y[i]);
  return points;
}

Content content_of(const RowMapData& data) {
  Content c;
  c.north_known = data.north_known;
  if (data.plants != nullptr) {
    const auto points = points_of(*data.plants);
    const auto& state = data.plants->texts("state");
    for (std::size_t i = 0; i < points.size(); ++i)
      (state[i] == "missing" ? c.missing : c.present).push_back(points[i]);
  }
  if (data.strays != nullptr) c.strays = points_of(*data.strays);
  if (data.lines != nullptr) {
    const auto points = points_of(*data.lines);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto id = data.lines->text("row_id", i, 0);
      if (c.lines.empty() || c.lines.back().id != id) c.lines.push_back({id, {}});
      c.lines.back().vertices.push_back(points[i]);
    }
  }
  return c;
}

Frame row_map_frame(const Content& c, double width_mm) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  Eigen::Vector2d lo(inf, inf), hi(-inf, -inf);
  for (const auto* points : {&c.present, &c.missing, &c.strays})
    for (const auto& p : *points) lo = lo.cwiseMin(p), hi = hi.cwiseMax(p);
  for (const auto& line : c.lines)  // of a drawn row without plants too
    for (const auto& p : line.vertices) lo = lo.cwiseMin(p), hi = hi.cwiseMax(p);
  if (!(lo.x() <= hi.x())) lo = {-1, -1}, hi = {1, 1};
  const Eigen::Vector2d middle = (lo + hi) / 2;
  const double pad = 0.05 * std::max((hi - lo).maxCoeff(), 1.0);
  Eigen::Vector2d half = ((hi - lo) / 2).array() + pad;
  // A long strip is widened, so that the sheet keeps a readable shape.
  half.y() = std::max(half.y(), 0.3 * half.x());
  half.x() = std::max(half.x(), half.y() / 1.35);
  const double w = width_mm - row_margin_left - row_margin_right, h = w * half.y() / half.x();
  return {{row_margin_left, row_margin_top, row_margin_left + w, row_margin_top + h},
          {middle.x() - half.x(), middle.x() + half.x()},
          {middle.y() - half.y(), middle.y() + half.y()}};
}

// The row's id beside its first end, on the line's prolongation.
void draw_id(Canvas& canvas, const Frame& frame, const Line& line) {
  if (line.vertices.size() < 2) return;
  const auto a = frame.map(line.vertices[0].x(), line.vertices[0].y()),
             b = frame.map(line.vertices[1].x(), line.vertices[1].y());
  if ((a - b).norm() < 1e-9) return;
  TextStyle style{5.5, ink::primary};
  style.halo_mm = 0.3;
  canvas.text(a + 2.0 * (a - b).normalized(), line.id, style.aligned(HAlign::centre, VAlign::middle));
}

// Half the distance of neighbours where plants stand densest, so that they stay apart. The plants of a row follow one
// another.
double dot_mm(const Points& plants_on_sheet) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < plants_on_sheet.size(); ++i)
    steps.push_back((plants_on_sheet[i] - plants_on_sheet[i - 1]).norm());
  if (steps.empty()) return 1.2;
  const auto tenth = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 10);
  std::nth_element(steps.begin(), tenth, steps.end());
  return std::clamp(0.5 * *tenth, 0.35, 1.4);
}

void draw_row_map(Canvas& canvas, const Content& c, const Frame& frame) {
  AxesStyle axes;
  axes.x_label = c.north_known ? "East (m)" : "x (m)";
  axes.y_label = c.north_known ? "North (m)" : "y (m)";
  axes.frame = true;
  axes.x_ticks = axes.y_ticks = 8;
  draw_grid(canvas, frame, axes);
  {
    const auto clip = canvas.clip(frame.box);
    const auto on_sheet = [&](const Points& points) {
      Points mapped;
      for (const auto& p : points) mapped.push_back(frame.map(p.x(), p.y()));
      return mapped;
    };
    for (const auto& line : c.lines) canvas.polyline(on_sheet(line.vertices), Stroke{ink::path.with_alpha(0.9), 0.25});
    const double dot = dot_mm(on_sheet(c.present));
    canvas.dots(on_sheet(c.present), dot, ink::good);
    for (const auto& p : on_sheet(c.missing)) canvas.circle(p, 0.6 * dot, {}, Stroke{ink::accent, 0.25});
    for (const auto& p : on_sheet(c.strays)) canvas.cross(p, 0.5 * dot, Stroke{ink::muted, 0.25});
    for (const auto& line : c.lines) draw_id(canvas, frame, line);
  }
  draw_axes(canvas, frame, axes);
  const double y = frame.box.y1 + row_margin_below + 5.5;
  const double bar_mm = draw_scale_bar(canvas, {frame.box.x0 + 1, y}, frame.mm_per_unit_x(), 40);
  if (c.north_known) draw_north_arrow(canvas, {frame.box.x0 + 1 + bar_mm + 12, y + 0.6}, 8);
  std::vector<LegendEntry> legend{{Symbol::disc, ink::good, "plant"}, {Symbol::line, ink::path, "row"}};
  if (!c.missing.empty()) legend.push_back({Symbol::ring, ink::accent, "missing"});
  if (!c.strays.empty()) legend.push_back({Symbol::cross, ink::muted, "in no row"});
  draw_legend_row(canvas, {frame.box.x0 + 1 + bar_mm + 20, y - 5.2}, frame.box.x1 - frame.box.x0 - bar_mm - 20, legend,
                  7);
}

}  // namespace

Figure row_map(const RowMapData& data, double width_mm) {
  auto content = content_of(data);
  const auto frame = row_map_frame(content, width_mm);
  Figure figure;
  figure.name = "row_map";
  figure.title = "Row map";
  figure.caption =
      "Plants, the lines of their rows with the row ids, places where a plant is missing, and plants in no row.";
  figure.width_mm = width_mm;
  figure.height_mm = frame.box.y1 + row_margin_below + row_furniture_mm;
  figure.draw = [content = std::move(content), frame](Canvas& canvas) { draw_row_map(canvas, content, frame); };
  return figure;
}

}  // namespace bole::render
