// Trees sway: by millimetres at breast height, by decimetres in the crown, and rays meet them where they are.
#include "sim/core/scene/wind.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>
#include <vector>

#include "modules/sim/plots.h"
#include "sim/core/plot/build_scene.h"
#include "sim/core/scene/ray_scene.h"

namespace bole::sim {
namespace {

struct WindyPlot {
  Forest forest;
  Wind wind;
  explicit WindyPlot(double speed, double from_rad = 1.5 * std::numbers::pi)
      : forest(make_forest(bare_plot(3), 1)), wind(forest.trees, {}, {speed, from_rad}, 60, 1) {}
};

TEST(Wind, moves_breast_height_by_millimetres_and_crowns_by_decimetres) {
  const WindyPlot plot(5);
  for (const auto& tree : plot.wind.trees()) {
    double low = 0, top = 0;
    for (double t = 0; t < 60; t += 0.1) {
      low = std::max(low, Wind::displacement(tree, 1.3, 0, t).norm());
      top = std::max(top, Wind::displacement(tree, tree.height_m, 0, t).norm());
      for (const double height : {1.3, 6.0, tree.height_m})
        EXPECT_LE(Wind::displacement(tree, height, 2.5, t).norm(), Wind::reach_m(tree, height));
      EXPECT_EQ(Wind::displacement(tree, 0, 0, t).norm(), 0);
    }
    EXPECT_GT(low, 0.0005);
    EXPECT_LT(low, 0.01);
    EXPECT_GT(top, 0.1);
    EXPECT_LT(top, 0.6);
  }
}

TEST(Wind, blows_from_its_direction_and_grows_with_the_square_of_its_speed) {
  const auto mean = [](const WindyPlot& plot) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (double t = 0; t < 60; t += 0.1) sum += Wind::displacement(plot.wind.trees()[0], 10, 0, t) / 600;
    return sum;
  };
  const Eigen::Vector2d west = mean(WindyPlot(4)), north = mean(WindyPlot(4, 0));
  EXPECT_GT(west.x(), 3 * std::abs(west.y()));     // from west: towards east
  EXPECT_LT(north.y(), -3 * std::abs(north.x()));  // from north: towards south
  // Across the wind there are no gusts: the same oscillation, by the deflection.
  const WindyPlot weak(2), strong(4);
  const auto across = [](const WindyPlot& plot, double t) {
    return Wind::displacement(plot.wind.trees()[0], 10, 0, t).y();
  };
  for (const double t : {3.0, 11.3, 40.1}) EXPECT_NEAR(across(strong, t) / across(weak, t), 4, 0.01) << t;
}

TEST(Wind, a_tree_swings_at_its_natural_frequency) {
  // Moore and Maguire 2004: a tree of 20 cm and 15 m swings about once in three seconds.
  EXPECT_NEAR(Wind::natural_frequency_hz(20, 15), 0.354, 0.001);
  // The strongest frequency of its motion across the wind, which has no gusts. Trees differ by 10 %.
  const WindyPlot plot(5);
  for (std::size_t i = 0; i < plot.forest.trees.size(); ++i) {
    const Tree& tree = plot.forest.trees[i];
    const double expected = Wind::natural_frequency_hz(100 * tree.taped.diameter_m, tree.stem.end_m);
    double strongest = 0, at_hz = 0;
    for (double f = 0.03; f < 2; f += 0.003) {
      std::complex<double> sum = 0;
      for (double t = 0; t < 60; t += 0.1)
        sum += Wind::displacement(plot.wind.trees()[i], tree.stem.end_m, 0, t).y() *
               std::polar(1.0, -2 * std::numbers::pi * f * t);
      if (std::abs(sum) > strongest) strongest = std::abs(sum), at_hz = f;
    }
    EXPECT_NEAR(at_hz / expected, 0.97, 0.12) << tree.id;
  }
}

// A ray from the side along +x meets the stem where it is at that moment: its front moves as the axis does.
TEST(Wind, rays_meet_stems_where_they_are) {
  const WindyPlot plot(8);
  SceneModel model = build_scene(plot.forest, 1).model;
  const RayScene calm(model), windy(model, &plot.wind);
  EXPECT_EQ(calm.triangles(), windy.triangles());
  for (std::size_t i = 0; i < plot.forest.trees.size(); ++i) {
    const Tree& tree = plot.forest.trees[i];
    for (const double height : {1.3, 3.0})
      for (const double t : {0.0, 1.7, 23.4}) {
        const Eigen::Vector3d axis = tree.stem.axis(height);
        constexpr double aside = 0.003;  // not through a corner of the mesh
        const auto range = [&](const RayScene& scene) {
          RayBundle rays;
          rays.time_s = t;
          for (int k = 0; k < RayBundle::size; ++k) {
            rays.origin[0][k] = static_cast<float>(axis.x()) - 1;
            rays.origin[1][k] = static_cast<float>(axis.y() + aside);
            rays.origin[2][k] = static_cast<float>(axis.z());
            rays.direction[0][k] = 1;
            rays.direction[1][k] = rays.direction[2][k] = 0;
          }
          RayHit hits[RayBundle::size];
          scene.intersect(rays, hits);
          EXPECT_EQ(hits[0].tree_id, tree.id);
          EXPECT_EQ(hits[0].material, Material::bark);
          return static_cast<double>(hits[0].range_m);
        };
        const Eigen::Vector2d moved = Wind::displacement(plot.wind.trees()[i], height, 0, t);
        // A round stem of radius r that is met by y beside its axis lies y^2 / 2r further back there.
        const double expected =
            moved.x() + (std::pow(aside - moved.y(), 2) - aside * aside) / (2 * tree.stem.mean_radius(height));
        EXPECT_NEAR(range(windy) - range(calm), expected, 3e-4) << tree.id << " at " << height << " m, " << t << " s";
      }
  }
}

// Both edges of a stem move with it: its width stays. A scene that only gave way would make stems thinner.
TEST(Wind, the_width_of_a_stem_stays) {
  const WindyPlot plot(10, 0);
  SceneModel model = build_scene(plot.forest, 1).model;
  const RayScene calm(model), windy(model, &plot.wind);
  const Tree& tree = plot.forest.trees[0];
  const auto edges = [&](const RayScene& scene, double t) {
    double left = 0, right = 0;
    bool any = false;
    for (double y = -0.5; y <= 0.5; y += 0.001) {
      RayBundle rays;
      rays.time_s = t;
      const Eigen::Vector3d axis = tree.stem.axis(2);
      for (int k = 0; k < RayBundle::size; ++k) {
        rays.origin[0][k] = static_cast<float>(axis.x()) - 1;
        rays.origin[1][k] = static_cast<float>(axis.y() + y);
        rays.origin[2][k] = static_cast<float>(axis.z());
        rays.direction[0][k] = 1;
        rays.direction[1][k] = rays.direction[2][k] = 0;
      }
      rays.max_range_m = 2;
      RayHit hits[RayBundle::size];
      scene.intersect(rays, hits);
      if (hits[0].tree_id != tree.id) continue;
      if (!any) left = y;
      right = y;
      any = true;
    }
    return std::pair(left, right);
  };
  const auto rest = edges(calm, 0);
  double widest_shift = 0;
  for (const double t : {2.0, 9.3, 31.1}) {
    const auto moved = edges(windy, t);
    EXPECT_NEAR(moved.second - moved.first, rest.second - rest.first, 0.0025) << t;
    widest_shift = std::max(widest_shift, std::abs(moved.first - rest.first));
  }
  EXPECT_GT(widest_shift, 0.005);
}

const std::vector<LowPlant> low_plants{{-1, LowPlantKind::shrub, {2, 0, 0.5}, {0, 0}, 1.2},
                                       {-2, LowPlantKind::grass, {3, 0, 0.5}, {0, 0}, 0.3},
                                       {-3, LowPlantKind::sapling, {4, 0, 0.5}, {0, 0}, 3}};

TEST(Wind, low_plants_move_by_centimetres_at_their_tops) {
  const Wind wind({}, low_plants, {5, 0}, 60, 1);
  ASSERT_EQ(wind.trees().size(), low_plants.size());
  for (std::size_t i = 0; i < low_plants.size(); ++i) {
    const auto& plant = wind.trees()[i];
    EXPECT_EQ(plant.id, low_plants[i].id);
    double top = 0;
    for (double t = 0; t < 60; t += 0.05) {
      top = std::max(top, Wind::displacement(plant, plant.height_m, 0, t).norm());
      EXPECT_EQ(Wind::displacement(plant, 0, 0, t).norm(), 0);
    }
    EXPECT_GT(top, 0.01) << i;
    EXPECT_LT(top, 0.2) << i;
  }
}

// An upright sheet across the ray, as an instance and as a piece of its own, stands for the plant.
TEST(Wind, rays_meet_low_plants_where_they_are) {
  const Wind wind({}, low_plants, {8, 1.5 * std::numbers::pi}, 60, 1);
  Piece sheet{{}, Material::leaf, 0.4F};
  for (const auto& [y, z] : {std::pair(-1.F, 0.F), std::pair(1.F, 0.F), std::pair(0.F, 2.F)}) sheet.mesh.add({0, y, z});
  sheet.mesh.triangles.push_back({0, 1, 2});
  SceneModel model;
  model.archetypes.push_back({{sheet}});
  for (const auto& plant : low_plants)
    model.placements.push_back({0, Eigen::Affine3f(Eigen::Translation3f(plant.foot.cast<float>())), plant.id});
  const RayScene scene(model, &wind);
  for (std::size_t i = 0; i < low_plants.size(); ++i)
    for (const double t : {0.4, 7.7, 31.2}) {
      const auto& plant = low_plants[i];
      const double height = 0.8 * std::min(1.0, plant.height_m);
      RayBundle rays;
      rays.time_s = t;
      for (int k = 0; k < RayBundle::size; ++k) {
        rays.origin[0][k] = static_cast<float>(plant.foot.x()) - 0.5F;
        rays.origin[1][k] = 0;
        rays.origin[2][k] = static_cast<float>(plant.foot.z() + height);
        rays.direction[0][k] = 1;
        rays.direction[1][k] = rays.direction[2][k] = 0;
      }
      RayHit hits[RayBundle::size];
      scene.intersect(rays, hits);
      const double moved = Wind::displacement(wind.trees()[i], height, 0, t).x();
      EXPECT_GT(std::abs(moved), 1e-4);
      EXPECT_NEAR(static_cast<double>(hits[0].range_m), 0.5 + moved, 1e-5) << i << " at " << t << " s";
      EXPECT_EQ(hits[0].material, Material::leaf);
    }
}

}  // namespace
}  // namespace bole::sim
