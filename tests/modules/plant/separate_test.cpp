#include "plant/core/separate/separate.h"

#include <gmock/gmock.h>

#include <cmath>

#include "base/random.h"
#include "synthetic/potted_plant.h"

namespace bole::plant {
namespace {

using tests::cloud_of;
using tests::CloudSettings;
using tests::PottedPlant;

// Share of the points of a kind that got each label. The plant's points come first in the cloud.
double share(const PointCloud& points, std::size_t begin, std::size_t end, Part part) {
  const auto& parts = points.values<std::int32_t>(part_column);
  std::size_t hits = 0;
  for (std::size_t i = begin; i < end; ++i) hits += parts[i] == static_cast<std::int32_t>(part);
  return static_cast<double>(hits) / static_cast<double>(end - begin);
}

TEST(Separate, FindsPlantPotSoilAndMat) {
  const PottedPlant plant;
  const CloudSettings settings;
  const auto cloud = cloud_of(plant, settings);
  const auto out = separate(cloud, nullptr, false, {}, {});
  const std::size_t n = plant.plant_points(settings.spacing, settings.seed).size();
  EXPECT_GT(share(out.points, 0, n, Part::plant), 0.985);
  // Of the rest nothing but a few points next to the stem is called plant.
  EXPECT_LT(share(out.points, n, cloud.size(), Part::plant), 0.003);
  EXPECT_EQ(out.scene.up_source, "board");
  EXPECT_EQ(out.scene.soil_source, "pot");
  EXPECT_NEAR(out.scene.rim_radius, plant.rim_radius, 0.0015);
  EXPECT_LT((out.scene.base - plant.foot).head<2>().norm(), 0.002);
  EXPECT_NEAR(out.scene.base.z(), plant.foot.z(), 0.0007);
  EXPECT_NEAR(out.scene.soil_height_at(out.scene.base), out.scene.base.z(), 1e-9);
  EXPECT_TRUE(out.scene.scale_known);
}

TEST(Separate, FindsUpWhereNobodySays) {
  const PottedPlant plant;
  auto cloud = cloud_of(plant);
  cloud.facts.clear();
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(2.1, Eigen::Vector3d(0.3, 1, -0.4).normalized()).toRotationMatrix();
  PointCloud::Positions moved;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    moved.push_back((turn * cloud.position(i) + Eigen::Vector3d(3, -2, 1)).cast<float>());
  cloud.set_positions(std::move(moved));
  const auto out = separate(cloud, nullptr, true, {}, {});
  EXPECT_EQ(out.scene.up_source, "plane");
  EXPECT_LT((out.scene.up - turn.col(2)).norm(), 0.01);
  EXPECT_LT((out.scene.base - (turn * plant.foot + Eigen::Vector3d(3, -2, 1))).norm(), 0.003);
}

// A cloud of a plant alone, half of whose points lie on two flat leaves: a leaf is not the table.
TEST(Separate, AFlatLeafIsNotTheGround) {
  PointCloud::Positions points;
  Random random(8, 0);
  for (int i = 0; i < 4000; ++i) {
    const double turn = random.uniform(0, 6.28);
    points.push_back(
        Eigen::Vector3d(0.01 * std::cos(turn), 0.01 * std::sin(turn), random.uniform(-0.7, 0.9)).cast<float>());
  }
  for (const double side : {-1.0, 1.0})
    for (int i = 0; i < 3000; ++i) {
      const double along = random.uniform(0.02, 0.6), across = random.uniform(-0.05, 0.05);
      points.push_back(Eigen::Vector3d(side * along, across, 0.1 * side + 0.9 * along).cast<float>());
    }
  const auto out = separate(PointCloud(std::move(points)), nullptr, false, {}, {});
  EXPECT_EQ(out.scene.up_source, "assumed");
  EXPECT_NEAR(out.scene.up.z(), 1, 1e-9);
  EXPECT_THAT(out.report.findings, testing::Contains(testing::Field(&Finding::code, "plant_up_assumed")));
}

TEST(Separate, FloatersAreNoPlant) {
  const PottedPlant plant;
  CloudSettings settings;
  settings.floaters = 400;
  const auto cloud = cloud_of(plant, settings);
  const auto out = separate(cloud, nullptr, false, {}, {});
  const std::size_t first = cloud.size() - 400;
  // Some fall onto the plant itself.
  EXPECT_LT(share(out.points, first, cloud.size(), Part::plant), 0.08);
  const auto& parts = out.points.values<std::int32_t>(part_column);
  double top = 0;
  for (std::size_t i = 0; i < parts.size(); ++i)
    if (parts[i] == 1) top = std::max(top, cloud.position(i).z());
  double truth = 0;
  for (const auto& p : plant.plant_points(0.001)) truth = std::max(truth, p.z());
  EXPECT_LT(top, truth + 0.004);
}

TEST(Separate, FactsGoRoundTrip) {
  const auto out = separate(cloud_of(PottedPlant{}), nullptr, false, {}, {});
  const auto again = scene_of(out.points.facts);
  EXPECT_EQ(again.base, out.scene.base);
  EXPECT_EQ(again.soil_offset, out.scene.soil_offset);
  EXPECT_EQ(again.table_height, out.scene.table_height);
}

TEST(Separate, RefusesWhatHasNoPlant) {
  EXPECT_THROW(separate(PointCloud{}, nullptr, false, {}, {}), Error);
  PointCloud::Positions one(500, Eigen::Vector3f(1, 2, 3));
  EXPECT_THROW(separate(PointCloud(one), nullptr, false, {}, {}), Error);
  SeparateOptions bad;
  bad.box = "0 0 0 1 1";
  EXPECT_THROW(separate(cloud_of(PottedPlant{}), nullptr, false, bad, {}), Error);
}

}  // namespace
}  // namespace bole::plant
