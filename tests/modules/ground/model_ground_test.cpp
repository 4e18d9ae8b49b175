#include "ground/core/model_ground.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>

#include "cloud/first_sight.h"
#include "synthetic/terrain.h"

namespace bole::ground {
namespace {

using synthetic::Terrain;
using synthetic::TerrainRecipe;
using ::testing::HasSubstr;

struct DemError {
  double bias = 0, rmse = 0, worst = 0;
  std::size_t cells = 0;
};

// DEM against truth over the middle of the plot; `measured_only` leaves filled cells out.
DemError dem_error(const GroundModel& model, const Terrain& truth, double half_m, bool measured_only = false) {
  DemError e;
  for (int iy = 0; iy < model.dem.ny; ++iy)
    for (int ix = 0; ix < model.dem.nx; ++ix) {
      const double x = model.dem.origin.x() + (ix + 0.5) * model.dem.cell_m,
                   y = model.dem.origin.y() + (iy + 0.5) * model.dem.cell_m;
      if (std::abs(x) > half_m || std::abs(y) > half_m || std::isnan(model.dem.at(ix, iy)) ||
          (measured_only && model.filled.at(ix, iy) > 0))
        continue;
      const double d = static_cast<double>(model.dem.at(ix, iy)) - truth.height(x, y);
      e.bias += d, e.rmse += d * d, e.worst = std::max(e.worst, std::abs(d)), ++e.cells;
    }
  e.bias /= static_cast<double>(e.cells), e.rmse = std::sqrt(e.rmse / static_cast<double>(e.cells));
  return e;
}

GroundModel model(const PointCloud& cloud, const GroundOptions& options = {}) {
  return model_ground(cloud, options, bole::Run{});
}

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

double height_difference(const GroundModel& a, const GroundModel& b,
                         const std::vector<std::uint32_t>* order = nullptr) {
  double worst = 0;
  for (std::size_t i = 0; i < b.height_above_ground.size(); ++i)
    worst = std::max(worst, std::abs(static_cast<double>(a.height_above_ground[order ? (*order)[i] : i]) -
                                     static_cast<double>(b.height_above_ground[i])));
  return worst;
}

TEST(ModelGround, LowNoiseIsFoundAndGroundIsKept) {
  Terrain terrain(forest());
  std::vector<int> labels;
  const auto cloud = terrain.cloud(&labels);
  const auto m = model(cloud);
  std::array<int, 2> ground{}, noise{};  // found, of
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] == 2) ++ground[1], ground[0] += m.classification[i] == 2;
    if (labels[i] == 7) ++noise[1], noise[0] += m.classification[i] == 7;
  }
  EXPECT_GT(ground[0], 0.995 * ground[1]);
  EXPECT_GT(noise[0], 0.995 * noise[1]);
  EXPECT_EQ(m.report.counts.at("low_noise_points"), std::count(m.classification.begin(), m.classification.end(), 7));
}

TEST(ModelGround, HolesUnderShrubsAreFilledAndMarked) {
  TerrainRecipe r;
  r.shrubs = 25, r.slope_deg = 30;
  Terrain terrain(r);
  const auto m = model(terrain.cloud());
  const auto all = dem_error(m, terrain, 9.5);
  printf("shrubs: bias %.4f rmse %.4f worst %.3f over %zu cells\n", all.bias, all.rmse, all.worst, all.cells);
  EXPECT_EQ(all.cells, 76U * 76U);  // none is missing
  EXPECT_LT(all.rmse, 0.04);        // the lowest leaves, 15 cm above ground, still lift the rims of the holes
  EXPECT_LT(dem_error(m, terrain, 9.5, true).cells, all.cells);
  EXPECT_NEAR(m.report.metrics.at("filled_share").value,
              100.0 * m.report.counts.at("filled_cells") / m.report.counts.at("dem_cells"), 1e-9);
  EXPECT_GT(m.report.counts.at("filled_cells"), 50);
}

TEST(ModelGround, BeyondTheFillDistanceThereIsNoTerrain) {
  TerrainRecipe r;
  r.slope_deg = 0;
  auto positions = Terrain(r).cloud().positions();
  positions.emplace_back(30.0F, 0.0F, 8.0F);  // a crown far outside
  GroundOptions o;
  o.fill_distance = 3;
  const auto m = model(PointCloud(positions), o);
  EXPECT_TRUE(std::isnan(m.height_above_ground.back()));
  EXPECT_EQ(m.classification.back(), 1);
  EXPECT_EQ(m.report.counts.at("points_without_height"), 1);
}

TEST(ModelGround, LargeCoordinatesChangeNothing) {
  const auto cloud = Terrain(forest()).cloud();
  PointCloud far(cloud.positions(), Eigen::Vector3d(512000, 5403000.5, 800.25));
  const auto a = model(cloud), b = model(far);
  EXPECT_LT(height_difference(a, b), 0.001);
  EXPECT_EQ(b.dem.nx, a.dem.nx);
  EXPECT_NEAR(b.dem.origin.x() - a.dem.origin.x(), 512000, 1e-6);
}

TEST(ModelGround, OrderOfPointsDoesNotMatter) {
  const auto cloud = Terrain(forest()).cloud();
  std::vector<std::uint32_t> order(cloud.size());
  std::iota(order.begin(), order.end(), 0U);
  std::shuffle(order.begin(), order.end(), std::mt19937(7));
  EXPECT_LT(height_difference(model(cloud), model(cloud.subset(order)), &order), 1e-4);
}

TEST(ModelGround, TurningThePlotTurnsTheModel) {
  const Terrain truth{forest()};
  const auto cloud = Terrain(forest()).cloud();
  const double c = std::cos(0.6), s = std::sin(0.6);
  PointCloud::Positions turned;
  for (const auto& p : cloud.positions())
    turned.emplace_back(static_cast<float>(c * static_cast<double>(p.x()) - s * static_cast<double>(p.y())),
                        static_cast<float>(s * static_cast<double>(p.x()) + c * static_cast<double>(p.y())), p.z());
  const auto m = model(PointCloud(turned));
  double squares = 0;
  int n = 0;
  for (double x = -9; x <= 9; x += 0.5)
    for (double y = -9; y <= 9; y += 0.5, ++n)
      squares += std::pow(m.dem.sample(c * x - s * y, s * x + c * y) - truth.height(x, y), 2);
  EXPECT_LT(std::sqrt(squares / n), 0.03);
}

TEST(ModelGround, DoubleDensityAgrees) {
  TerrainRecipe r = forest();
  Terrain sparse(r);
  r.ground_per_m2 *= 2;
  Terrain dense(r);
  EXPECT_NEAR(dem_error(model(sparse.cloud()), sparse, 9.5).bias, dem_error(model(dense.cloud()), dense, 9.5).bias,
              0.005);
}

TEST(ModelGround, SparseGroundIsStillFound) {
  TerrainRecipe r = forest();
  r.ground_per_m2 = 20;
  Terrain terrain(r);
  EXPECT_LT(dem_error(model(terrain.cloud()), terrain, 9).rmse, 0.08);
}

TEST(ModelGround, ForeignClassesAreKeptWhenAsked) {
  TerrainRecipe r;
  auto cloud = Terrain(r).cloud();
  std::vector<std::uint8_t> classes(cloud.size(), 1);
  classes[3] = 9, classes[4] = 7;
  cloud.set_column(arrays::classification, classes);
  GroundOptions o;
  EXPECT_EQ(model(cloud, o).classification[3], 9);
  EXPECT_EQ(model(cloud, o).classification[4], 2);
  o.keep_classes = false;
  EXPECT_EQ(model(cloud, o).classification[3], 2);
}

TEST(ModelGround, PointsThatAreNotFiniteGetNoHeight) {
  auto positions = Terrain(TerrainRecipe{}).cloud().positions();
  positions[10].z() = std::numeric_limits<float>::quiet_NaN();
  positions[11].x() = std::numeric_limits<float>::infinity();
  const auto m = model(PointCloud(positions));
  EXPECT_TRUE(std::isnan(m.height_above_ground[10]));
  EXPECT_TRUE(std::isnan(m.height_above_ground[11]));
  ASSERT_EQ(m.report.warnings.size(), 1U);
  EXPECT_THAT(m.report.warnings[0], HasSubstr("2 points"));
}

void expect_refused(const PointCloud& cloud, const GroundOptions& options, const std::string& words) {
  try {
    model(cloud, options);
    FAIL() << words;
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), HasSubstr(words));
  }
}

TEST(ModelGround, UselessCloudsAreRefusedInWords) {
  expect_refused(PointCloud(), {}, "none with finite coordinates");
  expect_refused(PointCloud({{0, 0, 0}, {1e7F, 1e7F, 0}}), {}, "too many cells");
  expect_refused(PointCloud({{0, 0, 0}}), {}, "ground points were found");
  expect_refused(PointCloud({{0, 0, 0}, {0, 0, 1}, {0, 0, 2}, {0, 0, 3}}), {}, "ground points were found");
}

TEST(ModelGround, CancelLeavesAtOnce) {
  std::stop_source stop;
  stop.request_stop();
  bole::Run run;
  run.cancel = stop.get_token();
  EXPECT_THROW(model_ground(Terrain(TerrainRecipe{}).cloud(), {}, run), Error);
}

TEST(ModelGround, ATreeWithoutGroundStandsOnItsLowestPoints) {
  PointCloud::Positions points;
  for (int i = 0; i < 4000; ++i)
    points.emplace_back(0.1F * std::cos(0.7F * static_cast<float>(i)), 0.1F * std::sin(0.7F * static_cast<float>(i)),
                        0.002F * static_cast<float>(i));
  points.emplace_back(0.0F, 0.0F, -5.0F);  // one stray point below
  const PointCloud tree(std::move(points), {500000, 5000000, 300});
  GroundOptions options;
  options.method = GroundMethod::lowest;
  const auto model = model_ground(tree, options, {});
  EXPECT_NEAR(model.height_above_ground[2000], 4.0, 0.02);
  EXPECT_NEAR(model.dem.sample(500000, 5000000), 300.0, 0.02);
  EXPECT_EQ(model.report.warnings.size(), 1u);
  // A cloud that says it is a single tree needs no option.
  auto told = tree;
  set_fact(told.facts, facts::kind, choice_name(CloudKind::single_tree));
  EXPECT_EQ(model_ground(told, {}, {}).height_above_ground, model.height_above_ground);
}

}  // namespace
}  // namespace bole::ground
