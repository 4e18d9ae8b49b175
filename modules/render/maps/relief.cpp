#include "render/maps/relief.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace bole::render {
namespace {

void add_level(const Raster& r, const RasterCells& c, double level, std::vector<ContourPiece>& pieces) {
  const auto centre = [&](int x, int y) -> Eigen::Vector2d {
    return r.origin + r.cell_m * Eigen::Vector2d(x + 0.5, y + 0.5);
  };
  for (int y = c.y0; y + 1 < c.y1; ++y)
    for (int x = c.x0; x + 1 < c.x1; ++x) {
      const std::array<double, 4> v{r.at(x, y), r.at(x + 1, y), r.at(x + 1, y + 1), r.at(x, y + 1)};
      const auto [lo, hi] = std::ranges::minmax(v);
      if (!std::isfinite(v[0] + v[1] + v[2] + v[3]) || lo >= level || hi < level) continue;
      const std::array<Eigen::Vector2d, 4> corner{centre(x, y), centre(x + 1, y), centre(x + 1, y + 1),
                                                  centre(x, y + 1)};
      std::vector<Eigen::Vector2d> hits;
      for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t n = (k + 1) % 4;
        if ((v[k] < level) != (v[n] < level))
          hits.emplace_back(corner[k] + (level - v[k]) / (v[n] - v[k]) * (corner[n] - corner[k]));
      }
      for (std::size_t k = 0; k + 1 < hits.size(); k += 2) pieces.push_back({hits[k], hits[k + 1], level});
    }
}

}  // namespace

RasterCells all_cells(const Raster& raster) { return {0, 0, raster.nx, raster.ny}; }

std::optional<Interval> value_range(const Raster& raster, const RasterCells& cells) {
  Interval range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (int y = cells.y0; y < cells.y1; ++y)
    for (int x = cells.x0; x < cells.x1; ++x)
      if (const double v = raster.at(x, y); std::isfinite(v)) range = {std::min(range.lo, v), std::max(range.hi, v)};
  if (!(range.lo <= range.hi)) return {};
  return range;
}

double hill_shade(const Raster& raster, int ix, int iy) {
  const auto at = [&](int x, int y) {
    const float v = raster.at(std::clamp(x, 0, raster.nx - 1), std::clamp(y, 0, raster.ny - 1));
    return std::isfinite(v) ? static_cast<double>(v) : static_cast<double>(raster.at(ix, iy));
  };
  const double gx = (at(ix + 1, iy) - at(ix - 1, iy)) / (2 * raster.cell_m),
               gy = (at(ix, iy + 1) - at(ix, iy - 1)) / (2 * raster.cell_m);
  const Eigen::Vector3d normal = Eigen::Vector3d(-gx, -gy, 1).normalized(), light(-0.5, 0.5, std::sqrt(0.5));
  return std::clamp(normal.dot(light) / light.z(), 0.35, 1.25);
}

Color terrain_color(double t, double shade) {
  Color color = mix(hex(0x7b9a76), hex(0xe9dcc0), t);
  for (double* channel : {&color.r, &color.g, &color.b}) *channel = std::clamp(*channel * shade, 0.0, 1.0);
  return color;
}

double contour_step_m(const Interval& heights) {
  constexpr double min_m = 0.05;  // below it lines show the noise of the ground points
  return std::max(nice_step(heights.length(), 8), min_m);
}

std::vector<ContourPiece> contours(const Raster& raster, const RasterCells& cells, const Interval& heights,
                                   double step_m) {
  std::vector<ContourPiece> pieces;
  for (double level = std::ceil(heights.lo / step_m) * step_m; level < heights.hi; level += step_m)
    add_level(raster, cells, level, pieces);
  return pieces;
}

}  // namespace bole::render
