#include "sim/core/plot/terrain.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/angles.h"
#include "sim/core/scene/noise.h"
#include "sim/core/scene/random.h"

namespace bole::sim {

Terrain::Terrain(const TerrainRecipe& recipe, std::uint64_t seed)
    : recipe_(recipe), seed_(Random(seed, Stream::terrain).next()) {
  const double aspect = radians(recipe.aspect_deg);
  // Downhill is towards the aspect, so the height falls that way.
  gradient_ = -std::tan(radians(recipe.slope_deg)) * Eigen::Vector2d(std::sin(aspect), std::cos(aspect));
  height_at_centre_ = shape(0, 0);
}

// The inclined plane, or terraces that climb it: level treads, risers that are steep and not quite straight.
double Terrain::slope_height(double x, double y) const {
  const double plane = gradient_.dot(Eigen::Vector2d(x, y)), slope = gradient_.norm(), width = recipe_.terrace_width_m;
  if (width <= 0 || slope <= 0) return plane;
  const double uphill = plane / slope + 0.5 * gradient_noise(x / 7, y / 7, seed_ + 211),
               step = std::floor(uphill / width);
  const double on_riser = std::clamp((uphill - step * width) / recipe_.terrace_riser_m, 0.0, 1.0);
  return slope * width * (step + on_riser * on_riser * (3 - 2 * on_riser));
}

double Terrain::shape(double x, double y) const {
  const double wave = recipe_.undulation_scale_m;
  double h = slope_height(x, y);
  h += recipe_.undulation_m * fractal_noise(x / wave, y / wave, 3, 0.4, seed_);
  h += recipe_.micro_relief_m * fractal_noise(x / 0.9, y / 0.9, 2, 0.5, seed_ + 101);
  return h;
}

Eigen::Vector3d Terrain::normal(double x, double y) const {
  constexpr double d = 0.01;
  return Eigen::Vector3d(height(x - d, y) - height(x + d, y), height(x, y - d) - height(x, y + d), 2 * d).normalized();
}

Raster Terrain::raster(double half_side_m, double cell_m) const {
  Raster dem;
  dem.cell_m = cell_m;
  dem.nx = dem.ny = static_cast<int>(std::ceil(2 * half_side_m / cell_m - 1e-9));
  dem.origin = Eigen::Vector2d::Constant(-0.5 * cell_m * dem.nx);
  dem.axes = Axes::plot;
  dem.values.resize(static_cast<std::size_t>(dem.nx) * static_cast<std::size_t>(dem.ny));
  for (int iy = 0; iy < dem.ny; ++iy)
    for (int ix = 0; ix < dem.nx; ++ix)
      dem.at(ix, iy) =
          static_cast<float>(height(dem.origin.x() + (ix + 0.5) * cell_m, dem.origin.y() + (iy + 0.5) * cell_m));
  return dem;
}

}  // namespace bole::sim
