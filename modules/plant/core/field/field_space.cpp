#include "plant/core/field/field_space.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bole::plant {
namespace {

// Distance along the ray to where it leaves the cube of edge `size` that holds `p` (in units of the cube's lattice).
float exit_distance(const Eigen::Vector3f& p, const Eigen::Vector3f& direction, float size) {
  float nearest = std::numeric_limits<float>::max();
  for (int k = 0; k < 3; ++k) {
    if (std::abs(direction(k)) < 1e-9F) continue;
    const float low = std::floor(p(k) / size) * size;
    const float wall = direction(k) > 0 ? low + size : low;
    nearest = std::min(nearest, (wall - p(k)) / direction(k));
  }
  return std::max(0.0F, nearest);
}

void cross_box(const FieldBox& box, FieldRay& ray, std::size_t i) {
  float enters = 0, leaves = std::numeric_limits<float>::max();
  const Eigen::Vector3f max = box.max();
  for (int k = 0; k < 3; ++k) {
    if (std::abs(ray.direction(k)) < 1e-9F) {
      if (ray.origin(k) < box.min(k) || ray.origin(k) > max(k)) leaves = -1;
      continue;
    }
    const float a = (box.min(k) - ray.origin(k)) / ray.direction(k), b = (max(k) - ray.origin(k)) / ray.direction(k);
    enters = std::max(enters, std::min(a, b));
    leaves = std::min(leaves, std::max(a, b));
  }
  ray.enters[i] = enters;
  ray.leaves[i] = leaves > enters ? leaves : -1;
}

}  // namespace

FieldSpace FieldSpace::around(const Region& region, double voxel, int count) {
  FieldSpace space;
  space.origin = region.centre();
  double size = voxel;
  Eigen::Vector3d half = region.size() / 2;
  for (int i = 0; i < count; ++i) {
    FieldBox box;
    box.voxel = static_cast<float>(size);
    box.blocks = (2 * half / (size * FieldBox::block_size)).array().ceil().cast<int>().max(1);
    box.min = -(box.blocks.cast<double>() * (size * FieldBox::block_size / 2)).cast<float>();
    box.block_of.assign(static_cast<std::size_t>(box.blocks.x()) * static_cast<std::size_t>(box.blocks.y()) *
                            static_cast<std::size_t>(box.blocks.z()),
                        -1);
    space.boxes.push_back(std::move(box));
    // The table around a plant is in every picture: the next box is not much coarser.
    const double wider = i == 0 ? 2 : 4;
    size *= wider;
    // Boxes further out are cubes: the room around a low plant is as high as it is wide.
    half = Eigen::Vector3d::Constant(half.maxCoeff() * wider);
  }
  return space;
}

void FieldSpace::set_cells(std::size_t index, const std::vector<std::uint64_t>& masks) {
  auto& box = boxes[index];
  std::vector<std::uint8_t> needed(box.block_of.size(), 0);
  const auto each = [&](auto visit) {
    for (int x = 0; x < box.blocks.x(); ++x)
      for (int y = 0; y < box.blocks.y(); ++y)
        for (int z = 0; z < box.blocks.z(); ++z) visit(Eigen::Vector3i(x, y, z));
  };
  each([&](const Eigen::Vector3i& b) {
    if (masks[box.block_index(b)] == 0) return;
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3i n = b + Eigen::Vector3i(corner >> 2, (corner >> 1) & 1, corner & 1);
      if ((n.array() < box.blocks.array()).all()) needed[box.block_index(n)] = 1;
    }
  });
  box.places.clear();
  box.cells.clear();
  each([&](const Eigen::Vector3i& b) {
    const auto i = box.block_index(b);
    box.block_of[i] = -1;
    if (needed[i] == 0) return;
    box.block_of[i] = static_cast<std::int32_t>(box.places.size());
    box.places.push_back(b);
    box.cells.push_back(masks[i]);
  });
  box.neighbours.assign(box.places.size(), {});
  for (std::size_t i = 0; i < box.places.size(); ++i)
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3i n = box.places[i] + Eigen::Vector3i(corner >> 2, (corner >> 1) & 1, corner & 1);
      // Beyond the border of the box the values of the last block are repeated.
      const auto at = (n.array() < box.blocks.array()).all() ? box.block_of[box.block_index(n)] : -1;
      box.neighbours[i][static_cast<std::size_t>(corner)] = at >= 0 ? at : static_cast<std::int32_t>(i);
    }
}

FieldRay FieldSpace::ray(const Eigen::Vector3f& from, const Eigen::Vector3f& direction, float jitter) const {
  FieldRay ray;
  ray.origin = from;
  ray.direction = direction;
  for (std::size_t i = 0; i < boxes.size(); ++i) cross_box(boxes[i], ray, i);
  ray.end = ray.leaves[boxes.size() - 1];
  ray.jitter = jitter;
  ray.at = ray.enters[boxes.size() - 1] + 1e-3F * boxes.back().voxel;
  return ray;
}

bool FieldSpace::next(FieldRay& ray, FieldSample& sample) const {
  while (ray.at < ray.end) {
    std::size_t index = boxes.size() - 1;
    float limit = ray.end;
    for (std::size_t i = 0; i + 1 < boxes.size(); ++i)
      if (ray.at >= ray.enters[i] && ray.at < ray.leaves[i]) {
        index = i;
        limit = ray.leaves[i];
        break;
      }
    // A box further in may begin before this one's next block ends.
    for (std::size_t i = 0; i < index; ++i)
      if (ray.leaves[i] > 0 && ray.enters[i] > ray.at) limit = std::min(limit, ray.enters[i]);
    const auto& box = boxes[index];
    const Eigen::Vector3f p = ray.origin + ray.direction * ray.at;
    const Eigen::Vector3f u = (p - box.min) / box.voxel;
    const Eigen::Vector3i lattice = u.array().floor().cast<int>();
    const float smallest = 1e-3F * box.voxel;
    if ((lattice.array() < 0).any() || (lattice.array() >= box.blocks.array() * FieldBox::block_size).any()) {
      ray.at += std::max(smallest, 1e-6F * ray.at);
      continue;
    }
    const Eigen::Vector3i place = lattice / FieldBox::block_size;
    const auto block = box.block_of[box.block_index(place)];
    const Eigen::Vector3i local = lattice - place * FieldBox::block_size;
    const int cell = ((local.x() >> 1) * 4 + (local.y() >> 1)) * 4 + (local.z() >> 1);
    if (block < 0 || box.cells[static_cast<std::size_t>(block)] == 0 ||
        (box.cells[static_cast<std::size_t>(block)] >> cell & 1) == 0) {
      const bool whole = block < 0 || box.cells[static_cast<std::size_t>(block)] == 0;
      const float exit = ray.at + exit_distance(u, ray.direction, whole ? FieldBox::block_size : 2) * box.voxel;
      // Samples lie on steps counted from the start, shifted by the jitter, so that walls of cells leave no pattern.
      const float length = step * box.voxel;
      const float aligned = (std::ceil((exit + smallest) / length - ray.jitter) + ray.jitter) * length;
      ray.at = std::max(ray.at + smallest, std::min(aligned, limit + smallest));
      continue;
    }
    sample.t = ray.at;
    sample.step = step * box.voxel;
    sample.position = p;
    sample.box = static_cast<std::uint8_t>(index);
    sample.block = block;
    sample.voxel = static_cast<std::uint16_t>((local.x() * 8 + local.y()) * 8 + local.z());
    sample.within = u - lattice.cast<float>();
    ray.at += sample.step;
    return true;
  }
  return false;
}

float FieldSpace::voxel_at(const Eigen::Vector3f& p) const {
  for (const auto& box : boxes)
    if ((p.array() >= box.min.array()).all() && (p.array() <= box.max().array()).all()) return box.voxel;
  return boxes.back().voxel;
}

std::size_t FieldSpace::block_count() const {
  std::size_t count = 0;
  for (const auto& box : boxes) count += box.places.size();
  return count;
}

}  // namespace bole::plant
