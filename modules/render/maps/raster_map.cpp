#include "render/maps/raster_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/option.h"
#include "render/charts/columns.h"
#include "render/draw/axes.h"
#include "render/draw/furniture.h"
#include "render/maps/relief.h"

namespace bole::render {
namespace {

constexpr double side_mm = 17, top_mm = 2;

struct RasterSheet {
  Image picture;
  Interval x, y, values;
  std::vector<ContourPiece> contours;
  std::vector<Eigen::Vector2d> stems, outline;
  RasterKind kind = RasterKind::terrain;
  double contour_step_m = 0;
  bool north_known = true;
};

RasterCells cells_shown(const Raster& r, const PlotArea& area) {
  RasterCells cells = all_cells(r);
  const auto outline = area.outline();
  if (outline.empty()) return cells;
  Eigen::Vector2d lo = outline.front(), hi = lo;
  for (const auto& p : outline) lo = lo.cwiseMin(p), hi = hi.cwiseMax(p);
  const double margin = 0.06 * (hi - lo).maxCoeff() + 1;
  const auto cell = [&](double v, double origin) { return static_cast<int>(std::floor((v - origin) / r.cell_m)); };
  const RasterCells near{
      std::max(0, cell(lo.x() - margin, r.origin.x())), std::max(0, cell(lo.y() - margin, r.origin.y())),
      std::min(r.nx, cell(hi.x() + margin, r.origin.x()) + 1), std::min(r.ny, cell(hi.y() + margin, r.origin.y()) + 1)};
  return near.x0 < near.x1 && near.y0 < near.y1 ? near : cells;
}

Interval values_shown(const Raster& r, const RasterCells& cells) {
  const auto range = value_range(r, cells);
  if (!range) throw bad_input("the raster of " + r.quantity + " has no value in the plot", "a terrain or canopy model");
  return range->length() < 0.1 ? Interval{range->lo - 0.05, range->hi + 0.05} : *range;
}

Image picture_of(const Raster& r, const RasterCells& c, RasterKind kind, const Interval& range) {
  Image image{c.x1 - c.x0, c.y1 - c.y0, {}};
  image.rgba.reserve(4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  for (int y = c.y1 - 1; y >= c.y0; --y)
    for (int x = c.x0; x < c.x1; ++x) {
      const double v = r.at(x, y);
      Color color = hex(0xffffff);
      if (std::isfinite(v)) {
        const double t = (v - range.lo) / range.length();
        color = kind == RasterKind::canopy ? ColorMap::viridis().at(t) : terrain_color(t, hill_shade(r, x, y));
      }
      for (const double channel : {color.r, color.g, color.b})
        image.rgba.push_back(static_cast<std::uint8_t>(std::lround(255 * channel)));
      image.rgba.push_back(255);
    }
  return image;
}

RasterSheet raster_sheet(const RasterMapData& data, RasterKind kind) {
  if (data.raster == nullptr || data.raster->values.empty()) throw bad_input("there is no raster", "a raster");
  const auto& r = *data.raster;
  const auto cells = cells_shown(r, data.area);
  RasterSheet s;
  s.kind = kind;
  s.north_known = data.north_known;
  s.values = values_shown(r, cells);
  if (kind == RasterKind::canopy) s.values.lo = std::min(0.0, s.values.lo);
  s.x = {r.origin.x() + cells.x0 * r.cell_m, r.origin.x() + cells.x1 * r.cell_m};
  s.y = {r.origin.y() + cells.y0 * r.cell_m, r.origin.y() + cells.y1 * r.cell_m};
  s.picture = picture_of(r, cells, kind, s.values);
  if (kind == RasterKind::terrain) {
    s.contour_step_m = contour_step_m(s.values);
    s.contours = contours(r, cells, s.values, s.contour_step_m);
  }
  s.outline = data.area.outline();
  if (data.stems != nullptr) {
    const auto x = numbers_or_nan(*data.stems, "x_m"), y = numbers_or_nan(*data.stems, "y_m");
    for (std::size_t i = 0; i < x.size(); ++i)
      if (x[i] >= s.x.lo && x[i] <= s.x.hi && y[i] >= s.y.lo && y[i] <= s.y.hi) s.stems.emplace_back(x[i], y[i]);
  }
  return s;
}

Frame raster_frame(const RasterSheet& s, double width_mm) {
  const double w = width_mm - axis_space_left_mm - side_mm, h = w * std::clamp(s.y.length() / s.x.length(), 0.3, 1.5);
  return {{axis_space_left_mm, top_mm, axis_space_left_mm + w, top_mm + h}, s.x, s.y};
}

void draw_sheet(Canvas& canvas, const RasterSheet& s, const Frame& frame) {
  {
    const auto clip = canvas.clip(frame.box);
    canvas.image(s.picture, frame.box);
    for (const auto& [a, b, height] : s.contours)
      canvas.line(frame.map(a.x(), a.y()), frame.map(b.x(), b.y()), Stroke{ink::contour.with_alpha(0.7), 0.15});
    std::vector<Eigen::Vector2d> line, dots;
    for (const auto& p : s.outline) line.push_back(frame.map(p.x(), p.y()));
    if (!line.empty()) canvas.polygon(line, {}, Stroke{ink::text, 0.35, {1.6, 1.0}});
    for (const auto& p : s.stems) dots.push_back(frame.map(p.x(), p.y()));
    canvas.dots(dots, 1.3, ink::paper);
    canvas.dots(dots, 0.9, ink::accent);
  }
  AxesStyle axes{s.north_known ? "East (m)" : "x (m)", s.north_known ? "North (m)" : "y (m)", 6, 6};
  axes.frame = true;
  draw_axes(canvas, frame, axes);
  const double x = frame.box.x1 + 3;
  const double bar = std::min(32.0, frame.box.height() - 12);
  const bool canopy = s.kind == RasterKind::canopy;
  draw_color_bar(canvas, {x, 9, x + 3, 9 + bar},
                 canopy ? ColorMap::viridis() : ColorMap({hex(0x7b9a76), hex(0xe9dcc0)}), s.values,
                 canopy ? "Height (m)" : "z (m)");
}

}  // namespace

Figure raster_map(const RasterMapData& data, RasterKind kind, double width_mm) {
  auto sheet = raster_sheet(data, kind);
  const auto frame = raster_frame(sheet, width_mm);
  const bool canopy = kind == RasterKind::canopy;
  Figure figure{canopy ? "canopy" : "terrain",
                canopy ? "Canopy height" : "Terrain",
                canopy ? "Height of the highest point above the terrain in each cell; dots are the stems."
                       : "The terrain model, lit from the north-west, with contour lines every " +
                             number_text(sheet.contour_step_m) + " m; dots are the stems.",
                width_mm,
                frame.box.y1 + axis_space_below_mm + 1,
                true,
                {}};
  figure.draw = [sheet = std::move(sheet), frame](Canvas& canvas) { draw_sheet(canvas, sheet, frame); };
  return figure;
}

}  // namespace bole::render
