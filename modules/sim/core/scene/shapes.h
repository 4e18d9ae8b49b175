// Building blocks of the scene's geometry.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/core/plot/stem_shape.h"
#include "sim/core/scene/random.h"
#include "sim/core/scene/scene_model.h"

namespace bole::sim {

// A tube through `path` with a radius at each point, closed at the end. Sides: 3 or more.
void add_tube(TriangleMesh& mesh, const std::vector<Eigen::Vector3d>& path, const std::vector<double>& radii,
              int sides);

// An upright cylinder with a lid and a bottom.
void add_cylinder(TriangleMesh& mesh, const Eigen::Vector3d& bottom, double radius_m, double height_m, int sides);

// A flat, slightly folded leaf of two triangles; `across` and `along` span it, half their lengths to each side.
void add_leaf(TriangleMesh& mesh, const Eigen::Vector3d& middle, const Eigen::Vector3d& along,
              const Eigen::Vector3d& across);

// The analytic stem from below the ground to its end. The vertices lie so that the facets have the shape's mean radius;
// `fine` keeps sides within 0.3 mm of it up to 2.6 m, the rest is coarse.
TriangleMesh stem_mesh(const StemShape& stem, bool fine);

// A boulder of radius about 1, flattened, from a displaced icosahedron.
TriangleMesh rock_mesh(Random& random);

Eigen::Vector3d random_direction(Random& random);

}  // namespace bole::sim
