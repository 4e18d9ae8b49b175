// Figures of rows: the steps from a frame to them, and them beside their reference.
#include <gtest/gtest.h>

#include "base/error.h"
#include "render/rows/oblique_view.h"
#include "render/rows/plant_cloud.h"
#include "render/rows/row_steps.h"

namespace bole::render {
namespace {

const Eigen::Vector3d low(-3, 0, -1), high(3, 12, 1);

Eigen::Vector3d corner(int k) {
  return {k & 1 ? high.x() : low.x(), k & 2 ? high.y() : low.y(), k & 4 ? high.z() : low.z()};
}

TEST(ObliqueView, TheWholeBoxIsOnTheSheetAtOneScale) {
  const Box sheet{10, 20, 70, 66};
  const ObliqueView view(low, high, sheet);
  for (int k = 0; k < 8; ++k) EXPECT_TRUE(sheet.contains(view.map(corner(k)))) << k;
  const auto length = [&](const Eigen::Vector3d& d) { return (view.map(low + d) - view.map(low)).norm(); };
  // Parallel projection: lengths grow evenly, and none is drawn longer than it is.
  EXPECT_NEAR(length({2, 0, 0}), 2 * length({1, 0, 0}), 1e-9);
  const double whole =
      std::sqrt(std::pow(length({1, 0, 0}), 2) + std::pow(length({0, 1, 0}), 2) + std::pow(length({0, 0, 1}), 2));
  EXPECT_LT(std::max({length({1, 0, 0}), length({0, 1, 0}), length({0, 0, 1})}), whole);
  // The sum of the squares of the three foreshortenings of an orthographic view is 2.
  EXPECT_NEAR(length({0, 0, 1}) / (whole / std::sqrt(2.0)), std::cos(24 * M_PI / 180), 1e-9);
}

TEST(ObliqueView, AheadIsUpAndRightIsRight) {
  const ObliqueView view(low, high, {0, 0, 60, 50});
  const auto from = view.map({0, 5, 0});
  EXPECT_GT(view.map({1, 5, 0}).x(), from.x());
  EXPECT_LT(view.map({0, 6, 0}).y(), from.y());
  EXPECT_LT(view.map({0, 5, 0.5}).y(), from.y());
}

PointCloud grid_of(int n) {
  PointCloud::Positions points;
  for (int i = 0; i < n; ++i)
    points.emplace_back(0.001F * static_cast<float>(i % 100), 0.001F * static_cast<float>(i / 100), 0);
  return PointCloud(std::move(points));
}

TEST(PlantCloud, AtMostAboutAsManyPointsAsAskedFor) {
  const auto cloud = grid_of(20000);
  auto box = box_of(cloud, false);
  box.round(0);
  const auto picked = sampled_in(cloud, box, 2000);
  EXPECT_NEAR(static_cast<double>(picked.size()), 2000, 200);
  EXPECT_EQ(sampled_in(grid_of(500), box, 2000).size(), 500U);
  // Evenly over the cloud, whatever the order of the points is.
  std::size_t first_half = 0;
  for (const auto i : picked) first_half += i < 10000 ? 1 : 0;
  EXPECT_NEAR(static_cast<double>(first_half), static_cast<double>(picked.size()) / 2, 100);
}

TEST(PlantCloud, PlantsHaveColoursAndTheRestIsGrey) {
  auto cloud = grid_of(3);
  cloud.set_column("plant", std::vector<std::int32_t>{0, 1, 2});
  const auto box = box_of(cloud, false);
  const auto drawn = plant_cloud(cloud, box, 10).points;
  const auto same = [](const Color& a, const Color& b) { return a.r == b.r && a.g == b.g && a.b == b.b; };
  EXPECT_FALSE(same(drawn[1].color, drawn[2].color));
  EXPECT_FALSE(same(drawn[0].color, drawn[1].color));
  EXPECT_EQ(plants_in(cloud), 2U);
  EXPECT_FALSE(box_of(cloud, true).contains(cloud.position(0))) << "the box about the plants";
}

TEST(RowSteps, AMissingStepIsRefused) { EXPECT_THROW(row_steps_sheet({}, 180), Error); }

}  // namespace
}  // namespace bole::render
