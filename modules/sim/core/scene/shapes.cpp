#include "sim/core/scene/shapes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "sim/core/scene/noise.h"

namespace bole::sim {
namespace {

using std::numbers::pi;

// Joins two rings of `sides` vertices that begin at `lower` and `upper`.
void join_rings(TriangleMesh& mesh, std::uint32_t lower, std::uint32_t upper, std::uint32_t sides) {
  for (std::uint32_t i = 0; i < sides; ++i) {
    const std::uint32_t j = (i + 1) % sides;
    mesh.triangles.push_back({lower + i, lower + j, upper + j});
    mesh.triangles.push_back({lower + i, upper + j, upper + i});
  }
}

void close_ring(TriangleMesh& mesh, std::uint32_t ring, std::uint32_t sides, const Eigen::Vector3d& tip) {
  const std::uint32_t top = mesh.add(tip.cast<float>());
  for (std::uint32_t i = 0; i < sides; ++i) mesh.triangles.push_back({ring + i, ring + (i + 1) % sides, top});
}

std::vector<double> ring_heights(const StemShape& stem, bool fine) {
  std::vector<double> heights;
  double h = -0.6;
  while (h < stem.end_m - 0.02) {
    heights.push_back(h);
    h += fine && h < 2.6 ? (h < 0.8 ? 0.04 : 0.08) : (h < 3 ? 0.25 : 0.6);
  }
  heights.push_back(stem.end_m - 0.01);
  return heights;
}

}  // namespace

void add_tube(TriangleMesh& mesh, const std::vector<Eigen::Vector3d>& path, const std::vector<double>& radii,
              int sides) {
  const auto n = static_cast<std::uint32_t>(sides);
  std::uint32_t previous = 0;
  Eigen::Vector3d u = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Eigen::Vector3d t = (path[std::min(i + 1, path.size() - 1)] - path[i > 0 ? i - 1 : 0]).normalized();
    // The first section axis is carried along the path, so that the tube does not twist.
    u = i == 0 ? t.unitOrthogonal() : (u - u.dot(t) * t).normalized();
    const Eigen::Vector3d v = t.cross(u);
    const auto ring = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int k = 0; k < sides; ++k) {
      const double a = 2 * pi * k / sides;
      mesh.add((path[i] + radii[i] * (std::cos(a) * u + std::sin(a) * v)).cast<float>());
    }
    if (i > 0) join_rings(mesh, previous, ring, n);
    previous = ring;
  }
  close_ring(mesh, previous, n, path.back());
}

void add_cylinder(TriangleMesh& mesh, const Eigen::Vector3d& bottom, double radius, double height, int sides) {
  const Eigen::Vector3d top = bottom + height * Eigen::Vector3d::UnitZ();
  const auto ring = static_cast<std::uint32_t>(mesh.vertices.size());
  add_tube(mesh, {bottom, top}, {radius, radius}, sides);
  close_ring(mesh, ring, static_cast<std::uint32_t>(sides), bottom);
}

void add_leaf(TriangleMesh& mesh, const Eigen::Vector3d& middle, const Eigen::Vector3d& along,
              const Eigen::Vector3d& across) {
  const Eigen::Vector3d lift = 0.15 * along.cross(across).normalized() * across.norm();
  const auto a = mesh.add((middle - along).cast<float>()), b = mesh.add((middle + across + lift).cast<float>());
  const auto c = mesh.add((middle + along).cast<float>()), d = mesh.add((middle - across + lift).cast<float>());
  mesh.triangles.push_back({a, b, c});
  mesh.triangles.push_back({a, c, d});
}

TriangleMesh stem_mesh(const StemShape& stem, bool fine) {
  // n sides lie within r (1 - cos(pi / n)), about r (pi / n)^2 / 2, of the circle, on average r (pi / n)^2 / 3 inside:
  // vertices go that far out.
  const double widest = stem.radius_m * (1 + stem.flare);
  const int sides = fine ? std::clamp(static_cast<int>(std::ceil(pi * std::sqrt(0.5 * widest / 0.0003))), 40, 128) : 20;
  const double centring = 1 + pi * pi / (3.0 * sides * sides);
  TriangleMesh mesh;
  std::uint32_t previous = 0;
  const std::vector<double> heights = ring_heights(stem, fine);
  mesh.vertices.reserve(heights.size() * static_cast<std::size_t>(sides) + 1);
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const double h = heights[i];
    const Eigen::Vector3d centre = stem.axis(h);
    const Eigen::Matrix<double, 3, 2> axes = stem.section_axes(h);
    const auto ring = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int k = 0; k < sides; ++k) {
      const double theta = 2 * pi * k / sides;
      mesh.add((centre + centring * stem.radius(h, theta) * (axes * Eigen::Vector2d(std::cos(theta), std::sin(theta))))
                   .cast<float>());
    }
    if (i > 0) join_rings(mesh, previous, ring, static_cast<std::uint32_t>(sides));
    previous = ring;
  }
  close_ring(mesh, previous, static_cast<std::uint32_t>(sides), stem.axis(heights.back()));
  return mesh;
}

TriangleMesh rock_mesh(Random& random) {
  TriangleMesh mesh;
  const float g = 0.5f * (1 + std::sqrt(5.0f));
  for (const auto& p :
       {Eigen::Vector3f(-1, g, 0), Eigen::Vector3f(1, g, 0), Eigen::Vector3f(-1, -g, 0), Eigen::Vector3f(1, -g, 0),
        Eigen::Vector3f(0, -1, g), Eigen::Vector3f(0, 1, g), Eigen::Vector3f(0, -1, -g), Eigen::Vector3f(0, 1, -g),
        Eigen::Vector3f(g, 0, -1), Eigen::Vector3f(g, 0, 1), Eigen::Vector3f(-g, 0, -1), Eigen::Vector3f(-g, 0, 1)})
    mesh.add(p.normalized());
  mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (int level = 0; level < 2; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto key = std::minmax(a, b);
      const auto it = middles.find(key);
      if (it != middles.end()) return it->second;
      return middles[key] = mesh.add((mesh.vertices[a] + mesh.vertices[b]).normalized());
    };
    std::vector<std::array<std::uint32_t, 3>> finer;
    for (const auto& t : mesh.triangles) {
      const auto ab = middle(t[0], t[1]), bc = middle(t[1], t[2]), ca = middle(t[2], t[0]);
      finer.insert(finer.end(), {{t[0], ab, ca}, {t[1], bc, ab}, {t[2], ca, bc}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
  }
  const auto seed = static_cast<std::uint32_t>(random.next());
  const auto flat = static_cast<float>(random.uniform(0.4, 0.8));
  for (auto& v : mesh.vertices) {
    v *= 0.65f + 0.7f * value_noise(1.7f * v.x() + 10, 1.7f * v.y() + 10, 1.7f * v.z() + 10, seed);
    v.z() *= flat;
  }
  return mesh;
}

Eigen::Vector3d random_direction(Random& random) {
  const double z = random.uniform(-1, 1), a = random.angle(), r = std::sqrt(1 - z * z);
  return {r * std::cos(a), r * std::sin(a), z};
}

}  // namespace bole::sim
