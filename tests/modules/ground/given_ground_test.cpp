// What a person gave to the ground or to noise.
#include "ground/core/given_ground.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"
#include "cloud/core/regions/point_edits.h"
#include "synthetic/terrain.h"

namespace bole::ground {
namespace {

// A plane at 0 with noise of 1 cm, and a slab of points at `z` over a square of 3 m about the middle, under which
// nothing of the ground is seen.
PointCloud plane_with_slab(float z) {
  synthetic::TerrainRecipe recipe;
  recipe.slope_deg = 0;
  recipe.undulation_m = 0;
  recipe.noise_m = 0.01;
  synthetic::Terrain terrain(recipe);
  auto positions = terrain.cloud().positions();
  std::erase_if(positions, [](const auto& p) { return std::abs(p.x()) < 1.5F && std::abs(p.y()) < 1.5F; });
  for (float x = -1.45F; x < 1.45F; x += 0.04F)
    for (float y = -1.45F; y < 1.45F; y += 0.04F) positions.emplace_back(x, y, z);
  return PointCloud(positions);
}

std::vector<std::uint8_t> slab_is(const PointCloud& cloud, const char* action) {
  const auto edits = parse_point_edits(std::string(R"([{"action": ")") + action +
                                       R"(", "centre": [0, 0, 0], "size_m": [2.95, 2.95, 6]}])");
  return given_classes(cloud, edits, {});
}

double terrain_at_middle(const GroundModel& model) { return model.dem.sample(0.1, 0.1); }

TEST(GivenGround, NoiseBelowTheGroundDoesNotPullTheTerrainDown) {
  const auto cloud = plane_with_slab(-0.5F);
  EXPECT_LT(terrain_at_middle(model_ground(cloud, {}, {})), -0.4);
  const auto given = slab_is(cloud, "to_noise");
  const auto model = model_edited_ground(cloud, given, nullptr, {}, {});
  EXPECT_NEAR(terrain_at_middle(model), 0, 0.03);
  ASSERT_EQ(model.classification.size(), cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    ASSERT_EQ(model.classification[i] == noise_class && std::isnan(model.height_above_ground[i]),
              given[i] == noise_class);
  }
  EXPECT_GT(model.report.counts.at("points_given_to_noise"), 4000);
}

TEST(GivenGround, ThePointsGivenCarryTheTerrain) {
  const auto cloud = plane_with_slab(1.2F);  // a block that the filter takes for an object
  EXPECT_LT(terrain_at_middle(model_ground(cloud, {}, {})), 0.3);
  const auto given = slab_is(cloud, "to_ground");
  const auto model = model_edited_ground(cloud, given, nullptr, {}, {});
  EXPECT_NEAR(terrain_at_middle(model), 1.2, 0.05);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (given[i] != 0) {
      ASSERT_EQ(model.classification[i], ground_class);
    }
  }
  // Over a terrain that is given they are ground by name alone.
  const auto terrain = model_ground(cloud, {}, {}).dem;
  const auto over = model_edited_ground(cloud, given, &terrain, {}, {});
  EXPECT_EQ(over.dem.values, terrain.values);
}

TEST(GivenGround, NothingButNoiseIsRefused) {
  const PointCloud cloud(PointCloud::Positions{{0, 0, 0}, {1, 0, 0}});
  EXPECT_THROW(model_edited_ground(cloud, {7, 7}, nullptr, {}, {}), Error);
}

}  // namespace
}  // namespace bole::ground
