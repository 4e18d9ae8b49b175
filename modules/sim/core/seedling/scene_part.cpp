#include "sim/core/seedling/scene_part.h"

#include <Eigen/Geometry>

namespace bole::sim {

void ScenePart::set_normals() {
  normals.assign(positions.size(), Eigen::Vector3f::Zero());
  for (const auto& [a, b, c] : triangles) {
    const Eigen::Vector3f n = (positions[b] - positions[a]).cross(positions[c] - positions[a]);
    for (const auto v : {a, b, c}) normals[v] += n;
  }
  for (auto& n : normals) n = n.squaredNorm() > 0 ? Eigen::Vector3f(n.normalized()) : Eigen::Vector3f::UnitZ();
}

}  // namespace bole::sim
