#include "ground/core/rasters.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace bole::ground {
namespace {

constexpr float missing = std::numeric_limits<float>::quiet_NaN();

Raster plane(double rise_x, double rise_y) {
  Raster r;
  r.origin = Eigen::Vector2d(100, 200), r.cell_m = 0.5, r.nx = 8, r.ny = 6;
  for (int iy = 0; iy < r.ny; ++iy)
    for (int ix = 0; ix < r.nx; ++ix)
      r.values.push_back(static_cast<float>(rise_x * ix * r.cell_m + rise_y * iy * r.cell_m));
  return r;
}

TEST(Rasters, SlopeOfAPlaneIsTheSameEverywhere) {
  const auto slope = slope_deg(plane(0.3, -0.4));
  EXPECT_EQ(slope.quantity, "slope_deg");
  for (const float s : slope.values) EXPECT_NEAR(s, std::atan(0.5) * 180 / std::numbers::pi, 1e-3);
}

TEST(Rasters, SlopeHoldsBesideHoles) {
  auto dem = plane(1, 0);
  dem.at(3, 3) = missing;
  const auto slope = slope_deg(dem);
  EXPECT_TRUE(std::isnan(slope.at(3, 3)));
  EXPECT_NEAR(slope.at(2, 3), 45, 1e-3);
  EXPECT_NEAR(slope.at(3, 2), 45, 1e-3);
}

TEST(Rasters, SlopeOfALoneCellIsUnknown) {
  Raster dem;
  dem.nx = dem.ny = 1, dem.values = {3};
  EXPECT_TRUE(std::isnan(slope_deg(dem).values[0]));
}

TEST(Rasters, CanopyIsTheHighestPointOfEachCell) {
  PointCloud cloud({{0.1F, 0.1F, 5}, {0.2F, 0.2F, 9}, {1.2F, 0.1F, -2}, {3.9F, 2.9F, 7}, {50, 0, 99}},
                   Eigen::Vector3d(100, 200, 0));
  cloud.set_column(arrays::height_above_ground, std::vector<float>{5, 9, -2, 7, 99});
  const auto chm = canopy_height(cloud, plane(0, 0), 1.0);
  EXPECT_EQ(chm.nx, 4);
  EXPECT_EQ(chm.ny, 3);
  EXPECT_EQ(chm.at(0, 0), 9);
  EXPECT_EQ(chm.at(1, 0), 0);
  EXPECT_EQ(chm.at(3, 2), 7);
  EXPECT_TRUE(std::isnan(chm.at(2, 1)));
  EXPECT_THROW(canopy_height(cloud, plane(0, 0), 0), Error);
  cloud.remove_column("height_above_ground");
  EXPECT_THROW(canopy_height(cloud, plane(0, 0), 1), Error);
}

}  // namespace
}  // namespace bole::ground
