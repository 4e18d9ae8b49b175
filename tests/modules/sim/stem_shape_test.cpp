#include "sim/core/plot/stem_shape.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace bole::sim {
namespace {

using std::numbers::pi;

Terrain level_ground() {
  TerrainRecipe recipe;
  recipe.slope_deg = recipe.undulation_m = recipe.micro_relief_m = 0;
  return Terrain(recipe, 1);
}

StemShape plain_stem(double diameter_m) {
  StemShape stem;
  stem.radius_m = 0.5 * diameter_m;
  stem.flare = stem.lobe_amplitude = 0;
  return stem;
}

TEST(Tape, reads_the_diameter_of_a_round_stem) {
  for (const double d : {0.08, 0.2, 0.6}) EXPECT_NEAR(tape(plain_stem(d), level_ground()).diameter_m, d, 1e-9);
}

TEST(Tape, is_laid_across_the_axis_of_a_leaning_stem) {
  StemShape stem = plain_stem(0.3);
  stem.taper_exponent = 0;
  stem.lean = {std::tan(20 * pi / 180), 0};
  const TapedStem taped = tape(stem, level_ground());
  EXPECT_NEAR(taped.diameter_m, 0.3, 1e-9);
  // 1.3 m along the stem, not upwards.
  EXPECT_NEAR(taped.h, 1.3 * std::cos(20 * pi / 180), 1e-9);
  EXPECT_NEAR(std::acos(taped.axis.z()), 20 * pi / 180, 1e-9);
}

TEST(Tape, spans_hollows) {
  StemShape stem = plain_stem(0.4);
  stem.amplitude = {0, 0.2, 0, 0};  // three ridges with hollows between
  const double taped = tape(stem, level_ground()).diameter_m;
  double contour = 0;
  for (int i = 0; i < 3600; ++i)
    contour += (stem.surface(1.3, 2 * pi * (i + 1) / 3600) - stem.surface(1.3, 2 * pi * i / 3600)).norm();
  EXPECT_LT(taped, contour / pi - 1e-3);
  EXPECT_GT(taped, 0.4);
}

TEST(Tape, reads_an_ellipse_as_ramanujan_does) {
  const double a = 0.22, b = 0.18;
  std::vector<Eigen::Vector2d> ellipse;
  for (int i = 0; i < 2000; ++i)
    ellipse.emplace_back(3 + a * std::cos(2 * pi * i / 2000), -1 + b * std::sin(2 * pi * i / 2000));
  const double h = std::pow((a - b) / (a + b), 2);
  const Girth girth = hull_girth(ellipse);
  EXPECT_NEAR(girth.length_m, pi * (a + b) * (1 + 3 * h / (10 + std::sqrt(4 - 3 * h))), 1e-5);
  EXPECT_NEAR(girth.centroid.x(), 3, 1e-9);
  EXPECT_NEAR(girth.centroid.y(), -1, 1e-9);
}

TEST(Tape, counts_breast_height_from_the_uphill_ground) {
  TerrainRecipe recipe;
  recipe.slope_deg = 20;
  recipe.aspect_deg = 270;  // falls to the west
  recipe.undulation_m = recipe.micro_relief_m = 0;
  const Terrain slope(recipe, 1);
  EXPECT_GT(slope.height(1, 0), slope.height(-1, 0));
  StemShape stem = plain_stem(0.3);
  stem.taper_exponent = 0;  // a cylinder
  const TapedStem taped = tape(stem, slope);
  EXPECT_NEAR(taped.ground_z_m, 0.20 * std::tan(20 * pi / 180), 1e-6);  // radius and a hand's breadth
  EXPECT_NEAR(taped.centre.z(), taped.ground_z_m + 1.3, 1e-9);
}

TEST(StemShape, a_section_is_perpendicular_to_the_axis) {
  StemShape stem = plain_stem(0.3);
  stem.lean = {0.1, -0.05};
  stem.bow = {0.2, 0.1};
  for (const double h : {0.3, 1.3, 4.0})
    for (const double theta : {0.0, 1.0, 4.0})
      EXPECT_NEAR((stem.surface(h, theta) - stem.axis(h)).dot(stem.tangent(h)), 0, 1e-12);
}

TEST(StemShape, flare_widens_the_foot_alone) {
  StemShape stem = plain_stem(0.3);
  stem.flare = 0.3;
  EXPECT_GT(stem.mean_radius(0), 1.3 * 0.15);
  EXPECT_NEAR(stem.mean_radius(1.3), 0.15, 0.001);
}

}  // namespace
}  // namespace bole::sim
