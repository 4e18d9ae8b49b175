#include "render/maps/raster_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/option.h"
#include "render/charts/columns.h"
#include "render/draw/axes.h"
#include "render/draw/furniture.h"

namespace bole::render {
namespace {

constexpr double side_mm = 17, top_mm = 2;

struct RasterSheet {
  Image picture;
  Interval x, y, values;
  std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>> contours;  // pieces of line, metres
  std::vector<Eigen::Vector2d> stems, outline;
  RasterKind kind = RasterKind::terrain;
  double contour_step_m = 0;
  bool north_known = true;
};

struct Cells {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // x1, y1: one past the last
};

Cells cells_shown(const Raster& r, const PlotArea& area) {
  Cells cells{0, 0, r.nx, r.ny};
  const auto outline = area.outline();
  if (outline.empty()) return cells;
  Eigen::Vector2d lo = outline.front(), hi = lo;
  for (const auto& p : outline) lo = lo.cwiseMin(p), hi = hi.cwiseMax(p);
  const double margin = 0.06 * (hi - lo).maxCoeff() + 1;
  const auto cell = [&](double v, double origin) { return static_cast<int>(std::floor((v - origin) / r.cell_m)); };
  const Cells near{std::max(0, cell(lo.x() - margin, r.origin.x())), std::max(0, cell(lo.y() - margin, r.origin.y())),
                   std::min(r.nx, cell(hi.x() + margin, r.origin.x()) + 1),
                   std::min(r.ny, cell(hi.y() + margin, r.origin.y()) + 1)};
  return near.x0 < near.x1 && near.y0 < near.y1 ? near : cells;
}

// Light from the north-west, 45 degrees above the horizon; 1 on level ground.
double hill_shade(const Raster& r, int ix, int iy) {
  const auto at = [&](int x, int y) {
    const float v = r.at(std::clamp(x, 0, r.nx - 1), std::clamp(y, 0, r.ny - 1));
    return std::isfinite(v) ? static_cast<double>(v) : static_cast<double>(r.at(ix, iy));
  };
  const double gx = (at(ix + 1, iy) - at(ix - 1, iy)) / (2 * r.cell_m),
               gy = (at(ix, iy + 1) - at(ix, iy - 1)) / (2 * r.cell_m);
  const Eigen::Vector3d normal = Eigen::Vector3d(-gx, -gy, 1).normalized(), light(-0.5, 0.5, std::sqrt(0.5));
  return std::clamp(normal.dot(light) / light.z(), 0.35, 1.25);
}

Interval value_range(const Raster& r, const Cells& c) {
  Interval range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (int y = c.y0; y < c.y1; ++y)
    for (int x = c.x0; x < c.x1; ++x)
      if (const double v = r.at(x, y); std::isfinite(v)) range = {std::min(range.lo, v), std::max(range.hi, v)};
  if (!(range.lo <= range.hi))
    throw bad_input("the raster of " + r.quantity + " has no value in the plot", "a terrain or canopy model");
  if (range.length() < 0.1) range = {range.lo - 0.05, range.hi + 0.05};
  return range;
}

Image picture_of(const Raster& r, const Cells& c, RasterKind kind, const Interval& range) {
  Image image{c.x1 - c.x0, c.y1 - c.y0, {}};
  image.rgba.reserve(4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  for (int y = c.y1 - 1; y >= c.y0; --y)
    for (int x = c.x0; x < c.x1; ++x) {
      const double v = r.at(x, y);
      Color color = hex(0xffffff);
      if (std::isfinite(v)) {
        const double t = (v - range.lo) / range.length();
        color = kind == RasterKind::canopy ? ColorMap::viridis().at(t) : mix(hex(0x7b9a76), hex(0xe9dcc0), t);
        const double shade = kind == RasterKind::terrain ? hill_shade(r, x, y) : 1;
        for (double* channel : {&color.r, &color.g, &color.b}) *channel = std::clamp(*channel * shade, 0.0, 1.0);
      }
      for (const double channel : {color.r, color.g, color.b})
        image.rgba.push_back(static_cast<std::uint8_t>(std::lround(255 * channel)));
      image.rgba.push_back(255);
    }
  return image;
}

// Where a level crosses the squares between cell centres (marching squares).
void add_contours(const Raster& r, const Cells& c, double level, RasterSheet& sheet) {
  const auto centre = [&](int x, int y) -> Eigen::Vector2d {
    return r.origin + r.cell_m * Eigen::Vector2d(x + 0.5, y + 0.5);
  };
  for (int y = c.y0; y + 1 < c.y1; ++y)
    for (int x = c.x0; x + 1 < c.x1; ++x) {
      const Eigen::Vector2d corner[] = {centre(x, y), centre(x + 1, y), centre(x + 1, y + 1), centre(x, y + 1)};
      const double v[] = {r.at(x, y), r.at(x + 1, y), r.at(x + 1, y + 1), r.at(x, y + 1)};
      if (!std::isfinite(v[0] + v[1] + v[2] + v[3])) continue;
      std::vector<Eigen::Vector2d> hits;
      for (int k = 0; k < 4; ++k) {
        const int n = (k + 1) % 4;
        if ((v[k] < level) != (v[n] < level))
          hits.emplace_back(corner[k] + (level - v[k]) / (v[n] - v[k]) * (corner[n] - corner[k]));
      }
      for (std::size_t k = 0; k + 1 < hits.size(); k += 2) sheet.contours.emplace_back(hits[k], hits[k + 1]);
    }
}

RasterSheet raster_sheet(const RasterMapData& data, RasterKind kind) {
  if (data.raster == nullptr || data.raster->values.empty()) throw bad_input("there is no raster", "a raster");
  const auto& r = *data.raster;
  const auto cells = cells_shown(r, data.area);
  RasterSheet s;
  s.kind = kind;
  s.north_known = data.north_known;
  s.values = value_range(r, cells);
  if (kind == RasterKind::canopy) s.values.lo = std::min(0.0, s.values.lo);
  s.x = {r.origin.x() + cells.x0 * r.cell_m, r.origin.x() + cells.x1 * r.cell_m};
  s.y = {r.origin.y() + cells.y0 * r.cell_m, r.origin.y() + cells.y1 * r.cell_m};
  s.picture = picture_of(r, cells, kind, s.values);
  if (kind == RasterKind::terrain) {
    s.contour_step_m = nice_step(s.values.length(), 8);
    for (double level = std::ceil(s.values.lo / s.contour_step_m) * s.contour_step_m; level < s.values.hi;
         level += s.contour_step_m)
      add_contours(r, cells, level, s);
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
    for (const auto& [a, b] : s.contours)
      canvas.line(frame.map(a.x(), a.y()), frame.map(b.x(), b.y()), Stroke{hex(0x6b4a2f, 0.7), 0.15});
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
