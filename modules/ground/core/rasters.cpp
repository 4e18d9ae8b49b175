#include "ground/core/rasters.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/angles.h"
#include "base/option.h"

namespace bole::ground {
namespace {

constexpr float no_height = std::numeric_limits<float>::quiet_NaN();

Raster same_place(const Raster& dem, double cell_m, std::string quantity) {
  Raster out;
  out.origin = dem.origin, out.axes = dem.axes, out.crs_wkt = dem.crs_wkt;
  out.cell_m = cell_m, out.quantity = std::move(quantity);
  out.nx = static_cast<int>(std::ceil(dem.nx * dem.cell_m / cell_m - 1e-9)),
  out.ny = static_cast<int>(std::ceil(dem.ny * dem.cell_m / cell_m - 1e-9));
  out.values.assign(static_cast<std::size_t>(out.nx) * static_cast<std::size_t>(out.ny), no_height);
  return out;
}

double value(const Raster& r, int ix, int iy) {
  return r.contains(ix, iy) ? static_cast<double>(r.at(ix, iy)) : std::nan("");
}

// Mean difference per cell along (dx, dy), of three parallel lines with weights 1 2 1; each by central, forward or
// backward difference, whichever the holes allow. NaN when none.
double gradient(const Raster& dem, int ix, int iy, int dx, int dy) {
  constexpr std::array<double, 3> weights{1, 2, 1};
  double sum = 0, weight = 0;
  for (int side = -1; side <= 1; ++side) {
    const int x = ix + side * dy, y = iy + side * dx;
    const double before = value(dem, x - dx, y - dy), here = value(dem, x, y), after = value(dem, x + dx, y + dy);
    double d = (after - before) / 2;
    if (std::isnan(d)) d = std::isnan(after - here) ? here - before : after - here;
    if (std::isnan(d)) continue;
    const int k = side + 1;
    const double w = weights[static_cast<std::size_t>(k)];
    sum += w * d, weight += w;
  }
  return weight > 0 ? sum / weight / dem.cell_m : std::nan("");
}

}  // namespace

Raster slope_deg(const Raster& dem) {
  Raster out = same_place(dem, dem.cell_m, "slope_deg");
  for (int iy = 0; iy < dem.ny; ++iy)
    for (int ix = 0; ix < dem.nx; ++ix)
      if (!std::isnan(dem.at(ix, iy)))
        out.at(ix, iy) = static_cast<float>(
            degrees(std::atan(std::hypot(gradient(dem, ix, iy, 1, 0), gradient(dem, ix, iy, 0, 1)))));
  return out;
}

Raster canopy_height(const PointCloud& cloud, const Raster& dem, double cell_m, const Run& run) {
  if (!(cell_m > 0)) throw bad_input("a canopy height cell of " + number_text(cell_m) + " m", "a positive size");
  const auto& height = cloud.values<float>(arrays::height_above_ground);
  Raster out = same_place(dem, cell_m, "canopy_height_m");
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if ((i & 0xfffffU) == 0) run.check_cancel();
    if (!std::isfinite(height[i])) continue;
    const Eigen::Vector3d p = cloud.position(i);
    const double u = std::floor((p.x() - out.origin.x()) / cell_m), v = std::floor((p.y() - out.origin.y()) / cell_m);
    if (!(u >= 0 && v >= 0 && u < out.nx && v < out.ny)) continue;
    float& highest = out.at(static_cast<int>(u), static_cast<int>(v));
    highest = std::max(std::isnan(highest) ? 0.0F : highest, height[i]);
  }
  return out;
}

}  // namespace bole::ground
