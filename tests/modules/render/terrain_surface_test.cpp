// The terrain as a surface with contour lines, for the 3-D view.
#include <gtest/gtest.h>
#include <vtkCell.h>
#include <vtkMapper.h>
#include <vtkPolyData.h>

#include <cmath>

#include "render/beside/terrain_surface.h"
#include "render/maps/relief.h"

namespace bole::render {
namespace {

constexpr double slope = 0.2;
const Eigen::Vector3d origin(500'000, 5'300'000, 400);

// Rises to the east.
Raster ramp(int side) {
  Raster raster;
  raster.origin = origin.head<2>();
  raster.cell_m = 0.5;
  raster.nx = raster.ny = side;
  for (int iy = 0; iy < side; ++iy)
    for (int ix = 0; ix < side; ++ix)
      raster.values.push_back(static_cast<float>(origin.z() + slope * raster.cell_m * (ix + 0.5)));
  return raster;
}

vtkPolyData* shape_of(vtkActor* actor) { return vtkPolyData::SafeDownCast(actor->GetMapper()->GetInput()); }

TEST(TerrainSurface, RunsThroughTheCentresOfCellsAndLeavesHolesOpen) {
  auto raster = ramp(21);
  raster.at(10, 10) = NAN;
  const auto surface = terrain_surface(raster, origin);
  auto* ground = shape_of(surface.ground);
  EXPECT_EQ(ground->GetNumberOfPoints(), 21 * 21 - 1);
  EXPECT_EQ(ground->GetNumberOfPolys(), 20 * 20 - 4);  // those about the hole
  for (vtkIdType i = 0; i < ground->GetNumberOfPoints(); ++i) {
    const double* p = ground->GetPoint(i);
    EXPECT_NEAR(p[2], slope * p[0], 2e-4);  // heights are floats
  }
}

TEST(TerrainSurface, ContourLinesLieAtRoundHeights) {
  const auto surface = terrain_surface(ramp(21), origin);  // 2 m between the outermost centres
  EXPECT_DOUBLE_EQ(surface.contour_step_m, 0.5);
  auto* lines = shape_of(surface.contours);
  EXPECT_EQ(lines->GetNumberOfLines(), 4 * 20);  // at 0.5, 1, 1.5 and 2 m
  for (vtkIdType i = 0; i < lines->GetNumberOfPoints(); ++i) {
    const double* p = lines->GetPoint(i);
    EXPECT_NEAR(std::remainder(p[0] * slope, 0.5), 0, 1e-3);  // the ground there has that height
    EXPECT_GT(p[2], p[0] * slope);                            // and does not hide the line
    EXPECT_LT(p[2], p[0] * slope + 0.03);
  }
}

TEST(TerrainSurface, OfALargeModelEverySecondCentreStaysInItsPlace) {
  const auto surface = terrain_surface(ramp(500), origin);
  auto* ground = shape_of(surface.ground);
  EXPECT_EQ(ground->GetNumberOfPoints(), 250 * 250);
  EXPECT_NEAR(ground->GetPoint(1)[0] - ground->GetPoint(0)[0], 1, 1e-6);
  for (const vtkIdType i : {0, 137, 62'499}) {
    const double* p = ground->GetPoint(i);
    EXPECT_NEAR(p[2], slope * p[0], 2e-4);
  }
}

TEST(TerrainSurface, LevelAndEmptyTerrain) {
  auto level = ramp(10);
  std::ranges::fill(level.values, 3.0F);
  EXPECT_TRUE(terrain_surface(level, origin).ground);
  EXPECT_FALSE(terrain_surface(level, origin).contours);
  EXPECT_EQ(terrain_surface(level, origin).contour_step_m, 0);
  level.at(3, 3) += 1e-6F;  // as good as level: no thousands of lines
  EXPECT_LE(contours(level, all_cells(level), *value_range(level, all_cells(level)),
                     contour_step_m(*value_range(level, all_cells(level))))
                .size(),
            4U);
  std::ranges::fill(level.values, NAN);
  EXPECT_FALSE(terrain_surface(level, origin).ground);
  EXPECT_EQ(terrain_surface(level, origin).contour_step_m, 0);
  level.at(3, 3) = 1;  // no square of four
  EXPECT_FALSE(terrain_surface(level, origin).ground);
}

// Slopes that face the light in the north-west are lighter than level ground, those that turn away darker.
TEST(Relief, IsShadedFromTheNorthWest) {
  auto raster = ramp(5);
  EXPECT_GT(hill_shade(raster, 2, 2), 1);  // faces west
  for (auto& v : raster.values) v = -v;
  EXPECT_LT(hill_shade(raster, 2, 2), 1);
  EXPECT_LT(terrain_color(0.5, 0.5).r, terrain_color(0.5, 1).r);
}

}  // namespace
}  // namespace bole::render
