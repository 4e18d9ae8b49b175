#include "sim/core/plot/deadwood.h"

#include <algorithm>
#include <cmath>

#include "sim/core/plot/plants.h"
#include "sim/core/scene/random.h"
#include "sim/core/scene/shapes.h"

namespace bole::sim {

bool is_free_ground(const Forest& forest, const Eigen::Vector3d& p, double distance) {
  if (forest.recipe.is_vineyard() && p.head<2>().cwiseAbs().maxCoeff() < forest.half_side_m()) return false;
  for (const auto& target : forest.targets)
    if ((target.middle - p).head<2>().norm() < 1.0 + distance) return false;
  return std::ranges::none_of(
      forest.trees, [&](const Tree& t) { return (t.stem.foot - p).head<2>().norm() < t.stem.radius_m + distance; });
}

void add_stumps(SceneModel& scene, const Forest& forest, Vegetation& vegetation, std::uint64_t seed) {
  const double reach = forest.half_side_m() + forest.recipe.buffer_m - 1;
  const auto count = std::lround(forest.recipe.terrain.stumps_per_ha * 4 * reach * reach / 1e4);
  Random random(seed, Stream::deadwood);
  Piece stumps{{}, Material::wood, wood_reflectivity};
  for (long i = 0; i < count; ++i) {
    const double x = random.uniform(-reach, reach), y = random.uniform(-reach, reach);
    const double radius = random.uniform(0.08, 0.28), tall = random.uniform(0.7, 1.2), low = random.uniform(0.15, 0.6);
    const double height = random.chance(0.15) ? tall : low;
    const Eigen::Vector3d at(x, y, forest.terrain.height(x, y));
    if (!is_free_ground(forest, at, radius + 0.3)) continue;
    // Wider at the ground, cut level on top.
    const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
    add_tube(stumps.mesh, {at - 0.4 * up, at, at + 0.25 * height * up, at + height * up},
             {1.35 * radius, 1.3 * radius, 1.08 * radius, radius}, 24);
    vegetation.obstacles.push_back({{x, y}, 1.3 * radius});
  }
  if (!stumps.mesh.empty()) scene.pieces.push_back(std::move(stumps));
}

}  // namespace bole::sim
