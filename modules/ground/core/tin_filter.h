// Ground by progressive densification of a triangulation.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "ground/core/low_points.h"
#include "ground/core/scales.h"
#include "ground/core/triangulation.h"

namespace bole::ground {

// A first, rough ground surface: the candidates taken for ground, and virtual points around them (`measured` is false)
// that carry the surface over holes and a little beyond the border.
struct GroundSurface {
  std::vector<Eigen::Vector3d> points;
  std::vector<Triangle> triangles;
  std::size_t measured = 0;  // the first so many points are candidates
};

// Progressive TIN densification after Axelsson (2000): the lowest candidate of each `seed` cell starts the
// triangulation; seeds that their neighbours contradict are dropped; then cell size is halved again and again, and
// candidates that lie close to the triangle below them in distance and angle join it, or close to the triangle mirrored
// at the nearest vertex (Axelsson's mirror point: that is how it grows over edges and the brows of slopes). After each
// level vertices that stand out of their neighbours leave again: unlike the original, a wrong seed (canopy, deep noise)
// is not kept for good. `pinned` candidates are ground and stay. `shape` is the grid the candidates were found in.
// Throws Error{bad_input} when fewer than three seeds are left.
GroundSurface tin_ground(const std::vector<LowPoint>& candidates, const std::vector<std::uint32_t>& pinned,
                         const GridShape& shape, const GroundScales& scales, const Run& run);

}  // namespace bole::ground
