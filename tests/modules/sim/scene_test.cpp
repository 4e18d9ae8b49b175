// The geometry that rays meet is the geometry that the truth is computed from.
#include <gtest/gtest.h>

#include <cmath>

#include "base/resources.h"
#include "modules/sim/plots.h"
#include "sim/core/plot/build_scene.h"
#include "sim/core/scene/random.h"
#include "sim/core/scene/ray_scene.h"
#include "sim/core/scene/shapes.h"

namespace bole::sim {
namespace {

RayHit cast(const RayScene& scene, const Eigen::Vector3d& from, const Eigen::Vector3d& direction) {
  RayBundle bundle;
  for (int i = 0; i < RayBundle::size; ++i)
    for (int d = 0; d < 3; ++d)
      bundle.origin[d][i] = static_cast<float>(from[d]), bundle.direction[d][i] = static_cast<float>(direction[d]);
  RayHit hits[RayBundle::size];
  scene.intersect(bundle, hits);
  return hits[0];
}

// Distance of a point from the stem's analytic surface, in its section.
double outside(const StemShape& stem, const Eigen::Vector3d& p) {
  double h = p.z() - stem.foot.z();
  for (int i = 0; i < 20; ++i) h += (p - stem.axis(h)).dot(stem.tangent(h)) * stem.tangent(h).z();
  const Eigen::Vector2d in_section = stem.section_axes(h).transpose() * (p - stem.axis(h));
  return in_section.norm() - stem.radius(h, std::atan2(in_section.y(), in_section.x()));
}

TEST(Scene, rays_meet_stems_on_their_analytic_surface) {
  const Forest forest = make_forest(read_recipe(resource_path("plots/mixed.json")), 2);
  Random random(1, Stream::pulse);
  double largest = 0, sum = 0;
  int count = 0;
  for (const auto& tree : forest.trees) {
    if (!tree.in_plot || tree.id > 20) continue;
    SceneModel alone;
    alone.pieces.push_back({stem_mesh(tree.stem, true), Material::bark, 0.4f, 0, tree.id});
    const RayScene scene(alone);
    for (int i = 0; i < 200; ++i) {
      const double h = random.uniform(0.5, 2.4), a = random.angle();
      const Eigen::Vector3d to = tree.stem.axis(h),
                            from = to + Eigen::Vector3d(3 * std::cos(a), 3 * std::sin(a), random.uniform(-1, 1));
      const Eigen::Vector3d direction = (to - from).normalized();
      const RayHit hit = cast(scene, from, direction);
      ASSERT_EQ(hit.tree_id, tree.id);
      const double error = outside(tree.stem, from + hit.range_m * direction);
      largest = std::max(largest, std::abs(error));
      sum += error;
      ++count;
    }
  }
  EXPECT_LT(largest, 0.5e-3);
  EXPECT_NEAR(sum / count, 0, 0.05e-3);  // facets are centred: no bias of the diameter
}

TEST(Scene, rays_meet_the_ground_where_the_terrain_is) {
  PlotRecipe recipe = bare_plot(1);
  recipe.terrain = TerrainRecipe{};
  recipe.terrain.rocks_per_ha = recipe.terrain.fallen_stems_per_ha = 0;
  const Forest forest = make_forest(recipe, 2);
  const RayScene scene(build_scene(forest, 2).model);
  Random random(1, Stream::pulse);
  int ground = 0;
  for (int i = 0; i < 500; ++i) {
    const double x = random.uniform(-5, 5), y = random.uniform(-5, 5);
    const RayHit hit = cast(scene, {x, y, 1.0 + forest.terrain.height(x, y)}, {0, 0, -1});
    if (hit.material != Material::ground) continue;
    ++ground;
    EXPECT_NEAR(hit.range_m, 1.0, 0.005);
  }
  EXPECT_GT(ground, 450);
}

TEST(Scene, placed_copies_turn_their_normals) {
  SceneModel model;
  Piece sheet;
  sheet.mesh.vertices = {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
  sheet.mesh.triangles = {{0, 1, 2}};
  sheet.reflectivity = 0.7f;
  model.archetypes.push_back({{sheet}});
  // Stood upright facing x, 2 m away.
  model.placements.push_back(
      {0, Eigen::Translation3f(2, 0, 0) * Eigen::Affine3f(Eigen::AngleAxisf(1.5707963f, Eigen::Vector3f::UnitY()))});
  const RayScene scene(model);
  const RayHit hit = cast(scene, {0, 0, 0}, Eigen::Vector3d(1, 0, 0));
  EXPECT_NEAR(hit.range_m, 2, 1e-5);
  EXPECT_NEAR(hit.cos_incidence, 1, 1e-5);
  EXPECT_FLOAT_EQ(hit.reflectivity, 0.7f);
  EXPECT_EQ(cast(scene, {0, 0, 0}, Eigen::Vector3d(-1, 0, 0)).range_m, 0);
}

}  // namespace
}  // namespace bole::sim
