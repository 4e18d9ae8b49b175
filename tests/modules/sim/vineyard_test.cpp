// The vineyard of the orchard experiment: its rows, the way through them, and the robot that drives it.
#include "sim/core/field/vineyard.h"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "base/error.h"
#include "base/resources.h"
#include "sim/core/plot/build_scene.h"
#include "sim/core/plot/simulate.h"
#include "sim/core/walk/route.h"
#include "sim/core/walk/walk.h"

namespace bole::sim {
namespace {

namespace fs = std::filesystem;

PlotRecipe recipe(const std::string& name) { return read_recipe(resource_path("plots/" + name + ".json")); }

TEST(Vineyard, every_alley_is_driven_both_ways_and_some_again) {
  const VineyardRecipe v = recipe("vineyard").vineyard;
  std::map<int, std::vector<int>> directions;  // by alley: +1 to the east
  const auto pattern = vineyard_pattern(v);
  for (std::size_t i = 1; i < pattern.size(); ++i) {
    const Eigen::Vector2d leg = pattern[i] - pattern[i - 1];
    if (std::abs(leg.x()) < v.row_length_m) continue;
    EXPECT_NEAR(leg.y(), 0, 1e-9);
    const double alley = pattern[i].y() / v.row_spacing_m + 0.5 * (v.rows - 2);
    EXPECT_NEAR(alley, std::round(alley), 1e-9);
    directions[static_cast<int>(std::lround(alley))].push_back(leg.x() > 0 ? 1 : -1);
  }
  ASSERT_EQ(directions.size(), static_cast<std::size_t>(v.rows - 1));
  for (const auto& [alley, d] : directions) {
    ASSERT_GE(d.size(), 2u);
    EXPECT_EQ(d[0], -d[1]) << "alley " << alley;
    EXPECT_EQ(d.size(), alley < v.repeats ? 3u : 2u);
    EXPECT_EQ(d[0], d.back() * (d.size() == 3 ? 1 : -1));
  }
}

TEST(Vineyard, the_route_is_600_m_long_and_never_touches_a_row) {
  const PlotRecipe r = recipe("vineyard");
  const Forest forest = make_forest(r, 1);
  const auto scene = build_scene(forest, 1);
  const auto route = plan_route(vineyard_pattern(r.vineyard), forest, scene.vegetation.obstacles, Walk::step_m);
  WalkParameters parameters;
  parameters.sensor_height_m = 1.1;
  parameters.carrier = Carrier::robot;
  EXPECT_GE(Walk(route, forest.terrain, parameters, 1).trajectory(100, 0).length_m(), 600);
  for (const auto& p : route) {
    if (std::abs(p.x()) > 0.5 * r.vineyard.row_length_m) continue;
    const double row = p.y() / r.vineyard.row_spacing_m + 0.5 * (r.vineyard.rows - 1);
    EXPECT_GT(r.vineyard.row_spacing_m * std::abs(row - std::round(row)), 1.0) << p.transpose();
  }
  for (const auto& tree : forest.trees) EXPECT_GT(tree.stem.foot.head<2>().cwiseAbs().maxCoeff(), 0.5 * r.size_m);
}

TEST(Vineyard, a_robot_stands_on_the_ground_under_its_tracks) {
  TerrainRecipe slope;
  slope.slope_deg = 10;
  slope.aspect_deg = 270;  // falls to the west: driving east is uphill
  slope.undulation_m = slope.micro_relief_m = 0;
  const Terrain terrain(slope, 1);
  std::vector<Eigen::Vector2d> route;
  for (int i = 0; i <= 40; ++i) route.emplace_back(Walk::step_m * i, 0);
  WalkParameters parameters;
  parameters.sensor_height_m = 1.1;
  parameters.gait = 0;
  parameters.carrier = Carrier::robot;
  const Walk walk(route, terrain, parameters, 1);
  const Pose T = walk.pose(6);
  const Eigen::Vector3d up = terrain.normal(0, 0);
  EXPECT_TRUE(T.linear().col(2).isApprox(up, 1e-9)) << T.linear().col(2).transpose();
  EXPECT_GT(T.linear().col(0).z(), 0.1);  // looks uphill
  const Eigen::Vector3d foot = T.translation() - 1.1 * up;
  EXPECT_NEAR(foot.z(), terrain.height(foot.x(), foot.y()), 1e-6);
  // With its engine on it shakes by hundredths of a degree.
  parameters.gait = 1;
  const Walk shaking(route, terrain, parameters, 1);
  const double tilt = std::acos(std::min(1.0, shaking.pose(6).linear().col(2).dot(up)));
  EXPECT_GT(tilt, 1e-5);
  EXPECT_LT(tilt, 0.5 * std::numbers::pi / 180);
}

TEST(Vineyard, a_recipe_whose_rows_do_not_fit_is_refused) {
  const auto error = [](nlohmann::json vineyard) {
    try {
      parse_recipe({{"size_m", 40}, {"layout", {{"kind", "vineyard"}}}, {"vineyard", std::move(vineyard)}});
    } catch (const Error& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_EQ(error({{"rows", 5}, {"row_length_m", 29}}), "");
  EXPECT_THAT(error({{"rows", 5}, {"row_length_m", 30}}), testing::HasSubstr("5.5 m of headland"));
  EXPECT_THAT(error({{"rows", 20}, {"row_length_m", 20}}), testing::HasSubstr("20 rows"));
  EXPECT_THAT(error({{"row_length_m", 20}, {"canopy_bottom_m", 1.9}}), testing::HasSubstr("less than canopy_top_m"));
}

TEST(Vineyard, an_OS1_sees_the_rows_beside_it) {
  const fs::path dir = fs::temp_directory_path() / ("bole_vineyard_" + std::to_string(::getpid()));
  SimulationOptions options;
  options.plot = "vineyard_short";
  options.sensor = "os1_64";
  options.carrier = Carrier::robot;
  options.sensor_height = 1.1;
  options.stand_still = 0;
  options.max_time = 0.2;
  options.noise = 0;
  simulate(options, dir, {});
  std::ifstream in(dir / "frames/000000.bin", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  EXPECT_EQ(fs::file_size(dir / "frames/000000.ring"), bytes.size() / 16 * 2);
  EXPECT_EQ(fs::file_size(dir / "frames/000000.time"), bytes.size() / 16 * 4);
  fs::remove_all(dir);
  ASSERT_GT(bytes.size() / 16, 20000u);
  // The start is 2.8 m before the rows in the middle of the first alley: rows 1.375 m to both sides and 4.125 m to the
  // left, nothing between them within the length of a few vines.
  std::size_t beside = 0, between = 0;
  for (std::size_t i = 0; i + 16 <= bytes.size(); i += 16) {
    std::array<float, 4> p{};
    std::memcpy(p.data(), bytes.data() + i, 16);
    if (p[0] < 4 || p[0] > 12 || p[2] < -0.2 || p[2] > 0.8) continue;  // half-way up the canopy
    const float off = std::abs(std::abs(p[1]) - 1.375f);
    beside += off < 0.35f;
    between += std::abs(p[1]) < 0.8f;
  }
  EXPECT_GT(beside, 1000u);
  EXPECT_LT(between, beside / 50);
}

}  // namespace
}  // namespace bole::sim
