#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <set>

#include "base/arrays.h"
#include "base/error.h"
#include "sim/core/field/field_recipe.h"
#include "sim/core/field/field_scene.h"
#include "sim/core/field/livox_scanner.h"
#include "sim/core/field/simulate_field.h"

namespace bole::sim {
namespace {

using ::testing::HasSubstr;

TEST(Field, TheTrialsOfThePaperHaveTheirAngles) {
  const double published[3][2] = {{-1.97, 3.55}, {-3.49, -0.40}, {-0.69, 1.60}};
  for (int k = 0; k < 3; ++k) {
    const auto rows = field_row_table(plant_field(read_field("tubes" + std::to_string(k + 1)), 1));
    ASSERT_EQ(rows.rows(), 2U);
    for (std::size_t r = 0; r < 2; ++r) EXPECT_NEAR(rows.numbers("angle_deg")[r], published[k][r], 0.04);
  }
}

TEST(Field, EveryRecipeGrows) {
  for (const auto& name : field_names()) {
    const auto field = plant_field(read_field(name), 3);
    const auto model = build_field_scene(field, 3);
    EXPECT_GT(model.pieces.size(), field.plants.size() / 2) << name;
    for (const auto& p : field.plants) {
      EXPECT_GE(1000 * p.diameter_m, field.recipe.plants.diameter_min_mm);
      EXPECT_LE(1000 * p.diameter_m, field.recipe.plants.diameter_max_mm);
    }
  }
}

TEST(Field, WrongRecipesAreNamed) {
  const auto error = [](const char* text) {
    try {
      parse_field(nlohmann::json::parse(text));
    } catch (const Error& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_THAT(error("[]"), HasSubstr("a JSON object"));
  EXPECT_THAT(error(R"({"plants": {"kind": "oak"}})"), HasSubstr("one of tube, tree, vine, apple"));
  EXPECT_THAT(error(R"({"plants": {"rows": 1e9}})"), HasSubstr("plants.rows"));
  EXPECT_THAT(error(R"({"plants": {"at": [[[1]]]}})"), HasSubstr("positions"));
  EXPECT_THAT(error(R"({"plant": {}})"), HasSubstr("unknown recipe field"));
  EXPECT_THAT(error(R"({"sensor": 3})"), HasSubstr("object"));
  EXPECT_THROW(read_field("tubes9"), Error);
}

// Share of cells of 0.4 degrees within the ellipse of the view that were hit.
double coverage(double seconds) {
  const RayScene empty{SceneModel{}};
  const LivoxScanner scanner({}, 1, empty, 1);
  std::set<std::pair<int, int>> hit;
  const double cell = 0.4, deg = std::numbers::pi / 180;
  for (std::int64_t n = 0; n < static_cast<std::int64_t>(seconds * scanner.model().rate_hz); ++n) {
    const auto d = scanner.direction(n);
    const double az = std::atan2(d.x(), d.y()) / deg, el = std::asin(d.z()) / deg;
    EXPECT_LE(std::abs(az), 40.86);
    EXPECT_LE(std::abs(el), 12.56);
    hit.insert({static_cast<int>(std::floor(az / cell)), static_cast<int>(std::floor(el / cell))});
  }
  return static_cast<double>(hit.size()) / (std::numbers::pi * 40.85 * 12.55 / (cell * cell));
}

TEST(Livox, TheRosetteFillsTheViewAndNeverRepeats) {
  const double tenth = coverage(0.1), half = coverage(0.5);
  printf("cells of 0.4 deg covered: %.0f %% in 0.1 s, %.0f %% in 0.5 s\n", 100 * tenth, 100 * half);
  EXPECT_GT(tenth, 0.5);
  EXPECT_GT(half, 0.95);
}

TEST(Livox, FramesAreDeterministicAndTheNoiseIsAsStated) {
  FieldSimulationOptions o;
  o.integration = 0.05;
  o.tilt = o.sway = 0;
  const auto a = simulate_field(o, {}), b = simulate_field(o, {});
  ASSERT_EQ(a.frames[0].size(), b.frames[0].size());
  EXPECT_EQ(a.frames[0].positions().back(), b.frames[0].positions().back());
  o.noise = 0;
  const auto exact = simulate_field(o, {});
  // The same pulses with and without noise: pair by time.
  const auto& ta = a.frames[0].values<double>(arrays::time);
  const auto& te = exact.frames[0].values<double>(arrays::time);
  double sum = 0, square = 0;
  int n = 0;
  for (std::size_t i = 0, j = 0; i < ta.size() && j < te.size();) {
    if (ta[i] < te[j])
      ++i;
    else if (ta[i] > te[j])
      ++j;
    else {
      const double e = a.frames[0].position(i++).norm() - exact.frames[0].position(j++).norm();
      sum += e;
      square += e * e;
      ++n;
    }
  }
  const double mean = sum / n, sd = std::sqrt(square / n - mean * mean);
  EXPECT_GT(n, 2000);
  EXPECT_LT(std::abs(mean), 0.015);  // the bias of the recording
  EXPECT_NEAR(sd, 0.02, 0.006);
}

TEST(Livox, ATubeIsHitWhereItStands) {
  FieldSimulationOptions o;
  o.field = "tubes2";
  o.noise = 0;
  o.integration = 0.2;
  const auto scan = simulate_field(o, {});
  const auto& tree = scan.frames[0].values<std::int32_t>(arrays::tree_id);
  const Eigen::Vector2d at(scan.plants.numbers("x_m")[0], scan.plants.numbers("y_m")[0]);
  const double yaw = scan.poses.numbers("yaw_deg")[0] * std::numbers::pi / 180;
  std::vector<double> off;
  for (std::size_t i = 0; i < tree.size(); ++i) {
    if (tree[i] != 1) continue;
    const Eigen::Vector3d level = rotation_from_rpy(scan.poses.numbers("roll_deg")[0] * std::numbers::pi / 180,
                                                    scan.poses.numbers("pitch_deg")[0] * std::numbers::pi / 180, yaw) *
                                  scan.frames[0].position(i);
    const Eigen::Vector2d p =
        level.head<2>() + Eigen::Vector2d(scan.poses.numbers("x_m")[0], scan.poses.numbers("y_m")[0]);
    off.push_back((p - at).norm());
  }
  ASSERT_GT(off.size(), 100U);
  std::ranges::sort(off);
  EXPECT_LT(off[off.size() / 4], 0.03);  // the tube itself: within its radius and a little lean
}

TEST(Livox, CanBeCancelled) {
  std::stop_source stop;
  stop.request_stop();
  bole::Run run;
  run.cancel = stop.get_token();
  EXPECT_THROW(simulate_field({}, run), Error);
}

}  // namespace
}  // namespace bole::sim
