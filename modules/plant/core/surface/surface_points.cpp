#include "plant/core/surface/surface_points.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace bole::plant {
namespace {

struct SurfacePoint {
  Eigen::Vector3f position = Eigen::Vector3f::Zero(), normal = Eigen::Vector3f::Zero(), color = Eigen::Vector3f::Zero();
  float weight = 0;
};

Eigen::Vector3f gradient(const Tsdf& grid, int x, int y, int z) {
  Eigen::Vector3f g = Eigen::Vector3f::Zero();
  const auto* middle = grid.find(x, y, z);
  for (int axis = 0; axis < 3; ++axis) {
    const auto* before = grid.find(x - (axis == 0), y - (axis == 1), z - (axis == 2));
    const auto* after = grid.find(x + (axis == 0), y + (axis == 1), z + (axis == 2));
    const bool has_before = before != nullptr && before->weight > 0, has_after = after != nullptr && after->weight > 0;
    if (has_before && has_after) {
      g(axis) = (after->distance - before->distance) / 2;
    } else if (has_after) {
      g(axis) = after->distance - middle->distance;
    } else if (has_before) {
      g(axis) = middle->distance - before->distance;
    }
  }
  return g;
}

// Whether the surface passes between two neighbours: a jump from far in front to far behind is a gap, no surface.
bool crosses(const Tsdf& grid, const Voxel& a, const Voxel& b, double min_weight) {
  return a.weight >= min_weight && b.weight >= min_weight && (a.distance > 0) != (b.distance > 0) &&
         std::abs(a.distance - b.distance) < 1.5 * grid.truncation;
}

SurfacePoint between(const Tsdf& grid, const Eigen::Vector3i& at, int axis, const Voxel& a, const Voxel& b) {
  const float s = a.distance / (a.distance - b.distance);
  SurfacePoint p;
  Eigen::Vector3i next = at;
  ++next(axis);
  p.position = at.cast<float>();
  p.position(axis) += s;
  p.position *= static_cast<float>(grid.voxel);
  p.normal = gradient(grid, at.x(), at.y(), at.z()) * (1 - s) + gradient(grid, next.x(), next.y(), next.z()) * s;
  const float length = p.normal.norm();
  if (length > 0) p.normal /= length;
  p.color = Eigen::Vector3f(a.red, a.green, a.blue) * (1 - s) + Eigen::Vector3f(b.red, b.green, b.blue) * s;
  p.weight = std::min(a.weight, b.weight);
  return p;
}

PointCloud cloud_of(const Tsdf& grid, const std::vector<SurfacePoint>& points) {
  PointCloud::Positions positions;
  std::vector<float> nx, ny, nz, weight;
  std::vector<std::uint16_t> red, green, blue;
  const auto value = [](float c) { return static_cast<std::uint16_t>(std::lround(std::clamp(c, 0.0F, 255.0F) * 257)); };
  positions.reserve(points.size());
  for (const auto& p : points) {
    positions.push_back(p.position);
    nx.push_back(p.normal.x());
    ny.push_back(p.normal.y());
    nz.push_back(p.normal.z());
    red.push_back(value(p.color.x()));
    green.push_back(value(p.color.y()));
    blue.push_back(value(p.color.z()));
    weight.push_back(p.weight);
  }
  PointCloud cloud(std::move(positions), grid.origin);
  cloud.set_column("normal_x", std::move(nx));
  cloud.set_column("normal_y", std::move(ny));
  cloud.set_column("normal_z", std::move(nz));
  cloud.set_column(arrays::red, std::move(red));
  cloud.set_column(arrays::green, std::move(green));
  cloud.set_column(arrays::blue, std::move(blue));
  cloud.set_column("weight", std::move(weight));
  return cloud;
}

// Calls `visit` with each lattice point of a block that has a voxel of enough weight.
template <class Visit>
void each_voxel(const Tsdf& grid, std::size_t block, double min_weight, Visit visit) {
  const Eigen::Vector3i start = grid.places[block] * Tsdf::block_size;
  const Voxel* voxel = &grid.voxels[block * Tsdf::block_voxels];
  for (int x = 0; x < Tsdf::block_size; ++x)
    for (int y = 0; y < Tsdf::block_size; ++y)
      for (int z = 0; z < Tsdf::block_size; ++z, ++voxel)
        if (voxel->weight >= min_weight) visit(Eigen::Vector3i(start + Eigen::Vector3i(x, y, z)), *voxel);
}

}  // namespace

PointCloud surface_points(const Tsdf& grid, double min_weight) {
  std::vector<std::vector<SurfacePoint>> parts(grid.places.size());
  tbb::parallel_for(std::size_t{0}, grid.places.size(), [&](std::size_t block) {
    each_voxel(grid, block, min_weight, [&](const Eigen::Vector3i& at, const Voxel& a) {
      for (int axis = 0; axis < 3; ++axis) {
        const auto* b = grid.find(at.x() + (axis == 0), at.y() + (axis == 1), at.z() + (axis == 2));
        if (b != nullptr && crosses(grid, a, *b, min_weight)) parts[block].push_back(between(grid, at, axis, a, *b));
      }
    });
  });
  std::vector<SurfacePoint> points;
  for (const auto& part : parts) points.insert(points.end(), part.begin(), part.end());
  return cloud_of(grid, points);
}

SurfaceMesh surface_mesh(const Tsdf& grid, double min_weight) {
  const auto key = [&](const Eigen::Vector3i& c) {
    return (static_cast<std::uint64_t>(c.x()) << 42) | (static_cast<std::uint64_t>(c.y()) << 21) |
           static_cast<std::uint64_t>(c.z());
  };
  std::unordered_map<std::uint64_t, std::int64_t> vertex_of;
  std::vector<SurfacePoint> vertices;
  std::vector<int> edges_of;
  std::vector<std::int64_t> a, b, c;
  // The vertex of a cell, fed by each edge of the cell that the surface crosses.
  const auto vertex = [&](const Eigen::Vector3i& cell, const SurfacePoint& p) {
    const auto [it, is_new] = vertex_of.try_emplace(key(cell), static_cast<std::int64_t>(vertices.size()));
    if (is_new) {
      vertices.emplace_back();
      edges_of.push_back(0);
    }
    auto& v = vertices[static_cast<std::size_t>(it->second)];
    v.position += p.position;
    v.normal += p.normal;
    v.color += p.color;
    v.weight += p.weight;
    ++edges_of[static_cast<std::size_t>(it->second)];
    return it->second;
  };
  for (std::size_t block = 0; block < grid.places.size(); ++block)
    each_voxel(grid, block, min_weight, [&](const Eigen::Vector3i& at, const Voxel& first) {
      for (int axis = 0; axis < 3; ++axis) {
        const auto* second = grid.find(at.x() + (axis == 0), at.y() + (axis == 1), at.z() + (axis == 2));
        if (second == nullptr || !crosses(grid, first, *second, min_weight)) continue;
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        if (at(u) == 0 || at(v) == 0) continue;
        const auto p = between(grid, at, axis, first, *second);
        std::array<std::int64_t, 4> corner{};
        for (int k = 0; k < 4; ++k) {
          Eigen::Vector3i cell = at;
          cell(u) -= k == 0 || k == 3;
          cell(v) -= k < 2;
          corner[static_cast<std::size_t>(k)] = vertex(cell, p);
        }
        // Outside is where the distance is positive.
        if (first.distance > 0) std::swap(corner[1], corner[3]);
        for (const std::size_t k : {1, 2}) {
          a.push_back(corner[0]);
          b.push_back(corner[k]);
          c.push_back(corner[k + 1]);
        }
      }
    });
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const auto n = static_cast<float>(edges_of[i]);
    vertices[i].position /= n;
    vertices[i].color /= n;
    vertices[i].weight /= n;
    if (const float length = vertices[i].normal.norm(); length > 0) vertices[i].normal /= length;
  }
  SurfaceMesh mesh{cloud_of(grid, vertices), {}};
  mesh.triangles.set("a", std::move(a));
  mesh.triangles.set("b", std::move(b));
  mesh.triangles.set("c", std::move(c));
  return mesh;
}

}  // namespace bole::plant
