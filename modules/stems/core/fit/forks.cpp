#include "stems/core/fit/forks.h"

#include <algorithm>
#include <cmath>

namespace bole::stems {

void note_fork(Stem& trunk, const StemCandidate& limb, double breast_height_m) {
  constexpr double above_m = 0.25;
  constexpr int min_limb_sections = 4;  // twigs make a circle or three
  if (limb.sections < min_limb_sections || limb.lowest < breast_height_m + above_m || limb.radius < 0.3 * trunk.radius)
    return;
  const double z = limb.ground_z + 0.5 * (limb.lowest + limb.highest);
  const Eigen::Vector2d at_limb =
      Eigen::Vector2d(limb.x, limb.y) + (z - limb.z) * Eigen::Vector2d(limb.slope_x, limb.slope_y);
  const Eigen::Vector2d at_trunk =
      (trunk.breast_height + (z - trunk.breast_height.z()) / trunk.direction.z() * trunk.direction).head<2>();
  if ((at_limb - at_trunk).norm() < 0.5 * trunk.radius) return;
  trunk.fork_m = std::isnan(trunk.fork_m) ? limb.lowest : std::min(trunk.fork_m, limb.lowest);
}

Stem* twin_of(const Stem& stem, std::vector<Stem>& better) {
  for (auto& o : better)
    if ((o.breast_height - stem.breast_height).head<2>().norm() <
        o.radius + stem.radius - 0.5 * std::min(o.radius, stem.radius))
      return &o;
  return nullptr;
}

}  // namespace bole::stems
