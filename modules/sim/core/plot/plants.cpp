#include "sim/core/plot/plants.h"

#include <cmath>

#include "sim/core/scene/shapes.h"

namespace bole::sim {
namespace {

constexpr float leaf_reflectivity = 0.45f, grass_reflectivity = 0.4f, rock_reflectivity = 0.3f;

}  // namespace

Archetype leaf_clump(Random& random) {
  TriangleMesh leaves;
  for (int i = 0; i < 70; ++i) {
    const Eigen::Vector3d at = 0.42 * std::cbrt(random.uniform()) * random_direction(random);
    const Eigen::Vector3d along = random_direction(random), across = along.cross(random_direction(random)).normalized();
    const double size = random.uniform(0.02, 0.04);
    add_leaf(leaves, Eigen::Vector3d(at.x(), at.y(), 0.7 * at.z()), size * along, 0.6 * size * across);
  }
  return {{Piece{std::move(leaves), Material::leaf, leaf_reflectivity}}};
}

Archetype needle_spray(Random& random) {
  TriangleMesh needles;
  for (int i = 0; i < 90; ++i) {
    const double x = random.uniform(-0.45, 0.45), half_width = 0.24 * (0.6 - 0.9 * x) + 0.03;
    const Eigen::Vector3d at(x, random.uniform(-half_width, half_width), random.uniform(-0.05, 0.03));
    const Eigen::Vector3d along = Eigen::Vector3d(1, at.y() > 0 ? 0.9 : -0.9, random.uniform(-0.4, 0.2)).normalized();
    add_leaf(needles, at, 0.05 * along, 0.006 * along.cross(random_direction(random)).normalized());
  }
  return {{Piece{std::move(needles), Material::leaf, leaf_reflectivity}}};
}

Archetype shrub(Random& random) {
  TriangleMesh twigs, leaves;
  const int stems = 7 + random.index(7);
  for (int s = 0; s < stems; ++s) {
    Eigen::Vector3d at(random.normal(0, 0.05), random.normal(0, 0.05), -0.1);
    Eigen::Vector3d heading = (Eigen::Vector3d(random.normal(0, 0.45), random.normal(0, 0.45), 1)).normalized();
    std::vector<Eigen::Vector3d> path{at};
    std::vector<double> radii{random.uniform(0.004, 0.009)};
    for (int k = 0; k < 5; ++k) {
      heading = (heading + 0.25 * random_direction(random)).normalized();
      at += random.uniform(0.15, 0.28) * heading;
      path.push_back(at);
      radii.push_back(0.8 * radii.back());
      const int count = k < 1 ? 4 : 14;
      for (int i = 0; i < count; ++i) {
        const Eigen::Vector3d along = random_direction(random),
                              across = along.cross(random_direction(random)).normalized();
        const double size = random.uniform(0.015, 0.035);
        add_leaf(leaves, at + 0.18 * std::cbrt(random.uniform()) * random_direction(random), size * along,
                 0.6 * size * across);
      }
    }
    add_tube(twigs, path, radii, 4);
  }
  return {{Piece{std::move(twigs), Material::wood, wood_reflectivity},
           Piece{std::move(leaves), Material::leaf, leaf_reflectivity}}};
}

Archetype vine_canopy(double height_m, double spacing_m, Random& random) {
  TriangleMesh shoots, leaves;
  const int count = 7 + random.index(5);
  for (int s = 0; s < count; ++s) {
    const double x = spacing_m * random.uniform(-0.52, 0.52), top = height_m * random.uniform(0.7, 1.15);
    std::vector<Eigen::Vector3d> path;
    std::vector<double> radii;
    constexpr int parts = 6;
    for (int k = 0; k <= parts; ++k) {
      path.emplace_back(x + random.normal(0, 0.02), random.normal(0, 0.03 + 0.01 * k), top * k / parts);
      radii.push_back(0.005 * (1 - 0.8 * k / parts));
      for (int i = 0; i < 6; ++i) {
        const Eigen::Vector3d along = random_direction(random),
                              side = along.cross(random_direction(random)).normalized();
        const double size = random.uniform(0.035, 0.065);
        add_leaf(leaves,
                 path.back() + Eigen::Vector3d(random.normal(0, 0.06), random.normal(0, 0.1), random.normal(0, 0.05)),
                 size * along, 0.85 * size * side);
      }
    }
    add_tube(shoots, path, radii, 4);
  }
  return {{Piece{std::move(shoots), Material::wood, wood_reflectivity},
           Piece{std::move(leaves), Material::leaf, leaf_reflectivity}}};
}

Archetype grass_tuft(Random& random) {
  TriangleMesh blades;
  for (int i = 0; i < 36; ++i) {
    const Eigen::Vector3d root(random.normal(0, 0.06), random.normal(0, 0.06), -0.02);
    const Eigen::Vector3d lean(random.normal(0, 0.35), random.normal(0, 0.35), 1);
    const Eigen::Vector3d tip = root + random.uniform(0.08, 0.32) * lean.normalized();
    add_leaf(blades, 0.5 * (root + tip), 0.5 * (tip - root),
             0.004 * Eigen::Vector3d(lean.y() + 0.3, 0.5 - lean.x(), 0).normalized());
  }
  return {{Piece{std::move(blades), Material::grass, grass_reflectivity}}};
}

Archetype rock(Random& random) { return {{Piece{rock_mesh(random), Material::rock, rock_reflectivity}}}; }

}  // namespace bole::sim
