// The bare ground of a simulated plot: an exact function that mesh, DEM and tree bases are all taken from.
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "cloud/raster.h"
#include "sim/core/plot/recipe.h"

namespace bole::sim {

class Terrain {
 public:
  Terrain(const TerrainRecipe& recipe, std::uint64_t seed);

  // Height in plot axes (m); zero at the plot centre.
  double height(double x, double y) const { return shape(x, y) - height_at_centre_; }
  // Upward unit normal from central differences over 2 cm.
  Eigen::Vector3d normal(double x, double y) const;

  // Heights at the cell centres of a square of the given half side about the plot centre.
  Raster raster(double half_side_m, double cell_m) const;

 private:
  double shape(double x, double y) const;
  double slope_height(double x, double y) const;
  TerrainRecipe recipe_;
  std::uint64_t seed_;
  Eigen::Vector2d gradient_;
  double height_at_centre_ = 0;
};

}  // namespace bole::sim
