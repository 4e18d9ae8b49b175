#include "plant/core/field/mask_hull.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/error.h"

namespace bole::plant {
namespace {

constexpr int min_views = 3, views_per_gap = 20;
constexpr double region_cells = 64, max_region_voxel_share = 1 / (2 * region_cells);
constexpr int cells_of_block = 4;

Eigen::Vector3f low_corner(const FieldBox& box, const Eigen::Vector3i& block, int cell) {
  const Eigen::Vector3i local =
      2 * Eigen::Vector3i(cell / 16, cell / cells_of_block % cells_of_block, cell % cells_of_block);
  return box.min + (block * FieldBox::block_size + local).cast<float>() * box.voxel;
}

}  // namespace

MaskHull::MaskHull(const std::vector<FieldView>& views) {
  for (const auto& view : views) {
    if (view.held_out || view.mask.empty()) continue;
    Outline outline{view.camera, view.T_world_camera.inverse(), {}};
    const auto width = static_cast<std::size_t>(view.mask.width) + 1;
    outline.sums.assign(width * (static_cast<std::size_t>(view.mask.height) + 1), 0);
    for (std::size_t y = 1; y <= static_cast<std::size_t>(view.mask.height); ++y)
      for (std::size_t x = 1; x < width; ++x)
        outline.sums[y * width + x] = outline.sums[(y - 1) * width + x] + outline.sums[y * width + x - 1] -
                                      outline.sums[(y - 1) * width + x - 1] +
                                      (view.mask.at(static_cast<int>(x) - 1, static_cast<int>(y) - 1) != 0 ? 1 : 0);
    outlines_.push_back(std::move(outline));
  }
}

bool MaskHull::Outline::shows_object(double x, double y, double radius_px) const {
  const auto width = static_cast<std::size_t>(camera.width) + 1;
  const auto within = [](double value, int size) {
    return static_cast<std::size_t>(std::clamp(value, 0.0, static_cast<double>(size)));
  };
  const auto x0 = within(std::floor(x - radius_px + 0.5), camera.width),
             x1 = within(std::ceil(x + radius_px + 0.5), camera.width),
             y0 = within(std::floor(y - radius_px + 0.5), camera.height),
             y1 = within(std::ceil(y + radius_px + 0.5), camera.height);
  return sums[y1 * width + x1] - sums[y0 * width + x1] - sums[y1 * width + x0] + sums[y0 * width + x0] > 0;
}

bool MaskHull::may_hold(const Eigen::Vector3d& middle_in_world, double radius_m) const {
  int seen = 0, empty = 0;
  const auto count = static_cast<int>(outlines_.size());
  for (const auto& outline : outlines_) {
    const Eigen::Vector3d p = outline.T_camera_world * middle_in_world;
    const auto pixel = outline.camera.project(p);
    if (!pixel || !outline.camera.contains(*pixel)) continue;
    ++seen;
    empty += !outline.shows_object(pixel->x(), pixel->y(), radius_m * std::abs(outline.camera.fx) / p.z());
    if (empty * views_per_gap > count) return false;
  }
  return seen >= std::min(min_views, count) && empty * views_per_gap <= seen;
}

std::vector<std::uint64_t> MaskHull::cells(const FieldSpace& space) const {
  const auto& box = space.boxes.front();
  std::vector<std::uint64_t> masks(box.block_of.size(), 0);
  const double radius = std::sqrt(3.0) * static_cast<double>(box.voxel);  // of a cell, two voxels wide
  const float edge = box.voxel * FieldBox::block_size;
  tbb::parallel_for(0, box.blocks.x(), [&](int bx) {
    for (int by = 0; by < box.blocks.y(); ++by)
      for (int bz = 0; bz < box.blocks.z(); ++bz) {
        const Eigen::Vector3i block(bx, by, bz);
        const Eigen::Vector3f middle = box.min + (block.cast<float>().array() + 0.5F).matrix() * edge;
        if (!may_hold(space.origin + middle.cast<double>(), cells_of_block * radius)) continue;
        std::uint64_t mask = 0;
        for (int cell = 0; cell < 64; ++cell) {
          const Eigen::Vector3f p = low_corner(box, block, cell).array() + box.voxel;
          if (may_hold(space.origin + p.cast<double>(), radius)) mask |= std::uint64_t{1} << cell;
        }
        masks[box.block_index(block)] = mask;
      }
  });
  return masks;
}

Region MaskHull::region(const Region& within) const {
  const double voxel = within.size().maxCoeff() * max_region_voxel_share;
  const auto space = FieldSpace::around(within, voxel, 1);
  const auto& box = space.boxes.front();
  const auto masks = cells(space);
  const float edge = 2 * box.voxel;
  Eigen::Vector3f low = box.max(), high = box.min;
  for (int bx = 0; bx < box.blocks.x(); ++bx)
    for (int by = 0; by < box.blocks.y(); ++by)
      for (int bz = 0; bz < box.blocks.z(); ++bz)
        for (auto left = masks[box.block_index({bx, by, bz})]; left != 0; left &= left - 1) {
          const Eigen::Vector3f corner = low_corner(box, {bx, by, bz}, std::countr_zero(left));
          low = low.cwiseMin(corner);
          high = high.cwiseMax((corner.array() + edge).matrix());
        }
  if ((low.array() >= high.array()).any())
    throw bad_input("the masks of the views leave no room in common", "masks that show one object from all sides",
                    "Check masks and poses, or give background=scene, which uses no masks");
  return {space.origin + low.cast<double>(), space.origin + high.cast<double>()};
}

}  // namespace bole::plant
