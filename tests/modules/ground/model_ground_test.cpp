#include "ground/core/model_ground.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "synthetic/terrain.h"

namespace bole::ground {
namespace {

using synthetic::Terrain;
using synthetic::TerrainRecipe;

struct DemError {
  double bias = 0, rmse = 0, worst = 0;
  std::size_t cells = 0;
};

// DEM against truth over the middle of the plot; `measured_only` leaves filled cells out.
DemError dem_error(const GroundModel& model, const Terrain& truth, double half_m, bool measured_only = false) {
  DemError e;
  for (int iy = 0; iy < model.dem.ny; ++iy)
    for (int ix = 0; ix < model.dem.nx; ++ix) {
      const double x = model.dem.origin.x() + (ix + 0.5) * model.dem.cell_m, y = model.dem.origin.y() + (iy + 0.5) * model.dem.cell_m;
      if (std::abs(x) > half_m || std::abs(y) > half_m || std::isnan(model.dem.at(ix, iy)) || (measured_only && model.filled.at(ix, iy) > 0)) continue;
      const double d = static_cast<double>(model.dem.at(ix, iy)) - truth.height(x, y);
      e.bias += d, e.rmse += d * d, e.worst = std::max(e.worst, std::abs(d)), ++e.cells;
    }
  e.bias /= static_cast<double>(e.cells), e.rmse = std::sqrt(e.rmse / static_cast<double>(e.cells));
  return e;
}

GroundModel model(const PointCloud& cloud, const GroundOptions& options = {}) { return model_ground(cloud, options, Run{}); }

TerrainRecipe forest() {
  TerrainRecipe r;
  r.rocks = 8, r.fallen_stems = 3, r.shrubs = 15, r.stems = 30, r.low_outlier_share = 0.002;
  return r;
}

TEST(ModelGround, PlaneWithNoiseIsMetInTheMiddleOfTheBand) {
  TerrainRecipe r;
  r.undulation_m = 0, r.noise_m = 0.03;
  Terrain terrain(r);
  const auto e = dem_error(model(terrain.cloud()), terrain, 9.5);
  RecordProperty("bias_mm", static_cast<int>(1000 * e.bias));
  EXPECT_LT(std::abs(e.bias), 0.003);
  EXPECT_LT(e.rmse, 0.008);
}

TEST(ModelGround, SteepForestFloorWithinThreeCentimetres) {
  for (const double slope : {0.0, 20.0, 35.0}) {
    TerrainRecipe r = forest();
    r.slope_deg = slope;
    Terrain terrain(r);
    const auto e = dem_error(model(terrain.cloud()), terrain, 9.5);
    printf("slope %g deg: bias %.4f rmse %.4f worst %.3f over %zu cells\n", slope, e.bias, e.rmse, e.worst, e.cells);
    EXPECT_LT(e.rmse, 0.03) << slope;
    EXPECT_LT(std::abs(e.bias), 0.01) << slope;
  }
}

TEST(ModelGround, GrassLiftsTheModelByLessThanTwoCentimetres) {
  TerrainRecipe r;
  r.grass_share = 0.4, r.grass_m = 0.10;
  Terrain terrain(r);
  const auto e = dem_error(model(terrain.cloud()), terrain, 9.5);
  printf("grass: bias %.4f rmse %.4f\n", e.bias, e.rmse);
  EXPECT_LT(std::abs(e.bias), 0.02);
}

}  // namespace
}  // namespace bole::ground
