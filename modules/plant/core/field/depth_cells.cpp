#include "plant/core/field/depth_cells.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace bole::plant {

DepthCells::DepthCells(const FieldSpace& space, DepthNoise noise) : space_(space), noise_(noise) {
  for (const auto& box : space.boxes) {
    now_.emplace_back(box.block_of.size());
    once_.emplace_back(box.block_of.size(), 0);
    twice_.emplace_back(box.block_of.size(), 0);
  }
}

void DepthCells::mark(const Eigen::Vector3f& p) {
  for (std::size_t i = 0; i < space_.boxes.size(); ++i) {
    const auto& box = space_.boxes[i];
    const Eigen::Vector3i lattice = ((p - box.min) / box.voxel).array().floor().cast<int>();
    if ((lattice.array() < 0).any() || (lattice.array() >= box.blocks.array() * FieldBox::block_size).any()) continue;
    const Eigen::Vector3i place = lattice / FieldBox::block_size, local = lattice - place * FieldBox::block_size;
    const int cell = ((local.x() >> 1) * 4 + (local.y() >> 1)) * 4 + (local.z() >> 1);
    now_[i][box.block_index(place)].fetch_or(std::uint64_t{1} << cell, std::memory_order_relaxed);
    return;  // the innermost box that holds it
  }
}

void DepthCells::add(const DepthImage& depth, const CameraModel& camera, const Pose& T_world_depth) {
  Eigen::Isometry3f T_field_depth = T_world_depth.cast<float>();
  T_field_depth.translation() = (T_world_depth.translation() - space_.origin).cast<float>();
  const bool distorted = camera.distorted();
  tbb::parallel_for(tbb::blocked_range<int>(0, depth.height, 8), [&](const auto& rows) {
    for (int y = rows.begin(); y < rows.end(); ++y)
      for (int x = 0; x < depth.width; ++x) {
        const float z = depth.at(x, y);
        if (!(z > 0) || !std::isfinite(z)) continue;
        const Eigen::Vector3f direction = distorted
                                              ? Eigen::Vector3f(camera.direction({x, y}).cast<float>())
                                              : Eigen::Vector3f(static_cast<float>((x - camera.cx) / camera.fx),
                                                                static_cast<float>((y - camera.cy) / camera.fy), 1);
        const Eigen::Vector3f middle = T_field_depth * Eigen::Vector3f(direction * z);
        const float voxel = space_.voxel_at(middle);
        const float band = std::max(3 * voxel, static_cast<float>(2.5 * noise_.sigma(z)));
        const int steps = static_cast<int>(std::ceil(band / (1.5F * voxel)));
        for (int s = -steps; s <= steps; ++s) {
          const float at = z + band * static_cast<float>(s) / static_cast<float>(steps);
          if (at > 0) mark(T_field_depth * Eigen::Vector3f(direction * at));
        }
      }
  });
  for (std::size_t b = 0; b < now_.size(); ++b)
    for (std::size_t i = 0; i < now_[b].size(); ++i) {
      const auto now = now_[b][i].exchange(0, std::memory_order_relaxed);
      twice_[b][i] |= once_[b][i] & now;
      once_[b][i] |= now;
    }
  ++views_;
}

std::size_t DepthCells::block_count() const {
  std::size_t count = 0;
  for (std::size_t b = 0; b < now_.size(); ++b)
    for (const auto mask : cells(b)) count += mask != 0;
  return count;
}

std::vector<std::uint64_t> all_cells(const FieldBox& box) {
  return std::vector<std::uint64_t>(box.block_of.size(), ~std::uint64_t{0});
}

}  // namespace bole::plant
