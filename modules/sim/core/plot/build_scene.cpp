#include "sim/core/plot/build_scene.h"

#include <cmath>

#include "sim/core/field/vineyard.h"
#include "sim/core/scene/random.h"
#include "sim/core/scene/shapes.h"

namespace bole::sim {
namespace {

constexpr float bare_ground_reflectivity = 0.22f, retro_reflectivity = 1.0f, pole_reflectivity = 0.3f;

// Heights on a square grid of `cells` x `cells` about the centre.
Piece ground_sheet(const Terrain& terrain, double half_side_m, double cell_m, double sink_m) {
  Piece piece{{}, Material::ground, bare_ground_reflectivity};
  const auto n = static_cast<std::uint32_t>(std::ceil(2 * half_side_m / cell_m)) + 1;
  const double start = -0.5 * cell_m * (n - 1);
  piece.mesh.vertices.reserve(std::size_t{n} * n);
  for (std::uint32_t iy = 0; iy < n; ++iy)
    for (std::uint32_t ix = 0; ix < n; ++ix) {
      const double x = start + ix * cell_m, y = start + iy * cell_m;
      piece.mesh.add(Eigen::Vector3d(x, y, terrain.height(x, y) - sink_m).cast<float>());
    }
  piece.mesh.triangles.reserve(2 * std::size_t{n - 1} * (n - 1));
  for (std::uint32_t iy = 0; iy + 1 < n; ++iy)
    for (std::uint32_t ix = 0; ix + 1 < n; ++ix) {
      const std::uint32_t a = iy * n + ix, b = a + 1, c = a + n, d = c + 1;
      piece.mesh.triangles.push_back({a, b, d});
      piece.mesh.triangles.push_back({a, d, c});
    }
  return piece;
}

void add_target(SceneModel& scene, const Target& target, const Terrain& terrain) {
  Piece foil{{}, Material::retro, retro_reflectivity}, pole{{}, Material::pole, pole_reflectivity};
  const Eigen::Vector3d bottom = target.middle - 0.5 * target.height_m * Eigen::Vector3d::UnitZ();
  add_cylinder(foil.mesh, bottom, target.radius_m, target.height_m, 48);
  const double ground = terrain.height(target.middle.x(), target.middle.y());
  add_cylinder(pole.mesh, Eigen::Vector3d(bottom.x(), bottom.y(), ground - 0.2), 0.015, bottom.z() - ground + 0.2, 10);
  scene.pieces.push_back(std::move(foil));
  scene.pieces.push_back(std::move(pole));
}

}  // namespace

PlotScene build_scene(const Forest& forest, std::uint64_t seed) {
  PlotScene scene;
  const double edge = forest.half_side_m() + forest.recipe.buffer_m + 2;
  // The fine sheet carries the micro-relief; beyond it a coarse one, a little lower where they overlap, closes the
  // view.
  scene.model.pieces.push_back(ground_sheet(forest.terrain, edge, 0.1, 0));
  scene.model.pieces.push_back(ground_sheet(forest.terrain, edge + 60, 3.0, 0.5));
  for (const auto& tree : forest.trees) {
    Random random(seed, Stream::branches, 1000000 + static_cast<std::uint64_t>(tree.id));
    const double reflectivity = tree.alive ? random.uniform(0.3, 0.5) : random.uniform(0.45, 0.6);
    scene.model.pieces.push_back(Piece{stem_mesh(tree.stem, tree.in_plot), Material::bark,
                                       static_cast<float>(reflectivity), static_cast<float>(tree.stem.bark_depth_m),
                                       tree.id});
  }
  scene.vegetation = add_vegetation(scene.model, forest, seed);
  if (forest.recipe.is_vineyard()) add_vineyard(scene.model, scene.vegetation, forest, seed);
  for (const auto& target : forest.targets) add_target(scene.model, target, forest.terrain);
  return scene;
}

}  // namespace bole::sim
