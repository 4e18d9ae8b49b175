#include "ground/core/triangulation.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace bole::ground {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase>>;

// Cells whose centre may lie within [low, high] along one axis.
std::pair<int, int> cell_range(double low, double high, double corner, double cell_m, int n) {
  const int first = static_cast<int>(std::ceil((low - corner) / cell_m - 0.5)),
            last = static_cast<int>(std::floor((high - corner) / cell_m - 0.5));
  return {std::max(first, 0), std::min(last, n - 1)};
}

// Where the horizontal line at `y` runs through the triangle; the first number is the greater one when it passes by.
std::pair<double, double> row_extent(const std::array<const Eigen::Vector3d*, 3>& corners, double y) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t k = 0; k < 3; ++k) {
    const Eigen::Vector3d &p = *corners[k], &q = *corners[(k + 1) % 3];
    if ((p.y() > y && q.y() > y) || (p.y() < y && q.y() < y)) continue;
    const double s = p.y() == q.y() ? 0.0 : (y - p.y()) / (q.y() - p.y());
    const double x = p.x() + s * (q.x() - p.x());
    low = std::min(low, x), high = std::max(high, x);
  }
  return {low, high};
}

}  // namespace

std::vector<Triangle> delaunay(std::span<const Eigen::Vector3d> points) {
  std::vector<std::pair<Kernel::Point_2, std::uint32_t>> input;
  input.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    input.emplace_back(Kernel::Point_2(points[i].x(), points[i].y()), static_cast<std::uint32_t>(i));
  const Delaunay triangulation(input.begin(), input.end());
  std::vector<Triangle> triangles;
  if (triangulation.dimension() < 2) return triangles;
  triangles.reserve(triangulation.number_of_faces());
  for (auto f = triangulation.finite_faces_begin(); f != triangulation.finite_faces_end(); ++f)
    triangles.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
  return triangles;
}

TrianglePlane::TrianglePlane(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c)
    : corner(a), gradient(Eigen::Vector2d::Zero()) {
  const Eigen::Vector3d normal = (b - a).cross(c - a);
  degenerate = !(std::abs(normal.z()) > 1e-12);
  if (!degenerate) gradient = -normal.head<2>() / normal.z();
}

Neighbourhood neighbourhood(std::span<const Triangle> triangles, std::size_t vertices) {
  // Each inner edge is met twice, once per triangle and direction; on the hull one direction is missing, so both are
  // noted.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
  edges.reserve(triangles.size() * 6);
  for (const auto& t : triangles)
    for (int k = 0; k < 3; ++k) {
      const auto a = t[static_cast<std::size_t>(k)], b = t[static_cast<std::size_t>((k + 1) % 3)];
      edges.emplace_back(a, b), edges.emplace_back(b, a);
    }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  Neighbourhood out;
  out.start.assign(vertices + 1, 0);
  out.neighbours.reserve(edges.size());
  for (const auto& [a, b] : edges) ++out.start[a + 1], out.neighbours.push_back(b);
  for (std::size_t v = 1; v <= vertices; ++v) out.start[v] += out.start[v - 1];
  return out;
}

Neighbourhood triangles_at_vertices(std::span<const Triangle> triangles, std::size_t vertices) {
  Neighbourhood out;
  out.start.assign(vertices + 1, 0);
  for (const auto& t : triangles)
    for (const auto v : t) ++out.start[v + 1];
  for (std::size_t v = 1; v <= vertices; ++v) out.start[v] += out.start[v - 1];
  out.neighbours.resize(out.start.back());
  auto next = out.start;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (const auto v : triangles[t]) out.neighbours[next[v]++] = static_cast<std::uint32_t>(t);
  return out;
}

void rasterise(std::span<const Eigen::Vector3d> points, std::span<const Triangle> triangles, const GridShape& shape,
               std::vector<float>& values) {
  for (const auto& t : triangles) {
    const Eigen::Vector3d &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
    const TrianglePlane plane(a, b, c);
    if (plane.degenerate) continue;
    const auto [y0, y1] = std::minmax({a.y(), b.y(), c.y()});
    const auto [first_row, last_row] = cell_range(y0, y1, shape.corner.y(), shape.cell_m, shape.ny);
    for (int iy = first_row; iy <= last_row; ++iy) {
      const auto [x0, x1] = row_extent({&a, &b, &c}, shape.centre(0, iy).y());
      const auto [first_column, last_column] = cell_range(x0, x1, shape.corner.x(), shape.cell_m, shape.nx);
      for (int ix = first_column; ix <= last_column; ++ix)
        values[shape.index(ix, iy)] = static_cast<float>(plane.at(shape.centre(ix, iy).x(), shape.centre(ix, iy).y()));
    }
  }
}

}  // namespace bole::ground
