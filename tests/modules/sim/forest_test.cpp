#include "sim/core/plot/forest.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "modules/sim/plots.h"

namespace bole::sim {
namespace {

TEST(Forest, has_the_count_mean_and_spread_of_its_recipe) {
  for (const char* plot : {"plot1", "plot2", "plot3", "plot4", "mixed"}) {
    const Forest forest = shipped(plot, 3);
    double n = 0, sum = 0, squares = 0;
    for (const auto& tree : forest.trees) {
      if (!tree.in_plot) continue;
      const double d = 100 * tree.taped.diameter_m;
      n += 1;
      sum += d;
      squares += d * d;
      EXPECT_GE(d, forest.recipe.trees.dbh_min_cm - 1e-3);
    }
    EXPECT_EQ(n, forest.recipe.trees.count) << plot;
    EXPECT_NEAR(sum / n, forest.recipe.trees.dbh_mean_cm, 0.005) << plot;
    EXPECT_NEAR(std::sqrt(squares / n - sum * sum / n / n), forest.recipe.trees.dbh_sd_cm, 0.01) << plot;
  }
}

TEST(Forest, trees_stand_apart_and_on_their_side_of_the_boundary) {
  const Forest forest = shipped("plot1", 5);
  const double half = forest.half_side_m();
  EXPECT_GT(forest.trees.size(), 150u);
  for (const auto& a : forest.trees) {
    EXPECT_EQ(a.in_plot, a.taped.centre.head<2>().cwiseAbs().maxCoeff() < half) << a.id;
    EXPECT_NEAR(a.stem.foot.z(), forest.terrain.height(a.stem.foot.x(), a.stem.foot.y()), 1e-9);
    for (const auto& b : forest.trees) {
      if (a.id >= b.id) continue;
      const double gap =
          (a.taped.centre - b.taped.centre).head<2>().norm() - 0.5 * (a.taped.diameter_m + b.taped.diameter_m);
      EXPECT_GT(gap, 0.02) << a.id << " and " << b.id;
    }
  }
}

TEST(Forest, depends_on_the_seed_alone) {
  const Forest a = shipped("demo", 1), b = shipped("demo", 1), c = shipped("demo", 2);
  EXPECT_EQ(a.trees[4].taped.centre, b.trees[4].taped.centre);
  EXPECT_NE(a.trees[4].taped.centre, c.trees[4].taped.centre);
}

TEST(Forest, rows_run_along_their_azimuth) {
  PlotRecipe recipe = bare_plot(0);
  recipe.layout.kind = LayoutKind::rows;
  recipe.layout.row_azimuth_deg = 90;
  recipe.layout.row_spacing_m = 3;
  recipe.layout.position_sd_m = 0;
  const Forest forest = make_forest(recipe, 1);
  ASSERT_GT(forest.trees.size(), 6u);
  for (const auto& tree : forest.trees) EXPECT_NEAR(std::abs(std::remainder(tree.stem.foot.y() - 1.5, 3.0)), 0, 1e-9);
}

TEST(Forest, too_many_trees_are_an_error_with_a_remedy) {
  PlotRecipe recipe = bare_plot(400);
  try {
    make_forest(recipe, 1);
    FAIL();
  } catch (const Error& e) {
    EXPECT_THAT(e.what(),
                testing::AllOf(testing::HasSubstr("400 trees do not fit"), testing::HasSubstr("Lower trees.count")));
  }
}

TEST(ExactSample, meets_moments_and_limits) {
  const auto values = exact_sample(30, 20, 10, 8, 60, 9);
  double sum = 0, squares = 0;
  for (const double v : values) {
    sum += v;
    squares += v * v;
  }
  EXPECT_NEAR(sum / 30, 20, 1e-3);
  EXPECT_NEAR(std::sqrt(squares / 30 - 400), 10, 1e-2);
  EXPECT_GE(std::ranges::min(values), 8);
  EXPECT_LE(std::ranges::max(values), 60);
}

TEST(Terrain, raster_equals_the_ground) {
  const Terrain terrain(TerrainRecipe{}, 4);
  EXPECT_EQ(terrain.height(0, 0), 0);
  const Raster dem = terrain.raster(5, 0.25);
  for (int iy = 0; iy < dem.ny; iy += 7)
    for (int ix = 0; ix < dem.nx; ix += 5)
      EXPECT_NEAR(dem.at(ix, iy),
                  terrain.height(dem.origin.x() + (ix + 0.5) * dem.cell_m, dem.origin.y() + (iy + 0.5) * dem.cell_m),
                  1e-6);
  EXPECT_NEAR(dem.sample(1.2, -3.4), terrain.height(1.2, -3.4), 0.01);
}

}  // namespace
}  // namespace bole::sim
