// Delaunay triangulation over the plane, and what is read off it.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "ground/core/point_grid.h"

namespace bole::ground {

using Triangle = std::array<std::uint32_t, 3>;  // indices of points, counter-clockwise

// Delaunay triangles of the points projected along z (CGAL). Of points with equal x and y one is used. Fewer than three
// points, or points on one line, give no triangles.
std::vector<Triangle> delaunay(std::span<const Eigen::Vector3d> points);

// z of the plane of a triangle at x, y.
struct TrianglePlane {
  TrianglePlane(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c);
  double at(double x, double y) const {
    return corner.z() + gradient.x() * (x - corner.x()) + gradient.y() * (y - corner.y());
  }
  Eigen::Vector3d corner;
  Eigen::Vector2d gradient;
  bool degenerate = false;  // no area: gradient is zero
};

// Neighbours of each vertex, as lists in one array: those of v are neighbours[start[v]] to neighbours[start[v + 1] -
// 1].
struct Neighbourhood {
  std::vector<std::uint32_t> start, neighbours;
  std::span<const std::uint32_t> of(std::size_t v) const {
    return {neighbours.data() + start[v], neighbours.data() + start[v + 1]};
  }
};
Neighbourhood neighbourhood(std::span<const Triangle> triangles, std::size_t vertices);

// Indices of the triangles at each vertex, likewise.
Neighbourhood triangles_at_vertices(std::span<const Triangle> triangles, std::size_t vertices);

// Linear interpolation at the cell centres of a grid; cells outside the triangulation keep what `values` holds.
void rasterise(std::span<const Eigen::Vector3d> points, std::span<const Triangle> triangles, const GridShape& shape,
               std::vector<float>& values);

}  // namespace bole::ground
