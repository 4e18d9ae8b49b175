#include "plant/core/field/grid_reshape.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace bole::plant {
namespace {

constexpr int edge = FieldBox::block_size;

// Index of lattice point (x, y, z), each 0 to 8, counted from a block's first.
std::size_t lattice_index(const FieldBox& box, std::size_t block, int x, int y, int z) {
  const int neighbour = (x >> 3) * 4 + (y >> 3) * 2 + (z >> 3), within = ((x & 7) * edge + (y & 7)) * edge + (z & 7);
  const auto at = static_cast<std::size_t>(box.neighbours[block][static_cast<std::size_t>(neighbour)]);
  return at * FieldBox::block_voxels + static_cast<std::size_t>(within);
}

bool cell_is_set(const FieldBox& box, const std::vector<std::uint64_t>& cells, const Eigen::Vector3f& p) {
  const Eigen::Vector3i lattice = ((p - box.min) / box.voxel).array().floor().cast<int>();
  if ((lattice.array() < 0).any() || (lattice.array() >= box.blocks.array() * edge).any()) return false;
  const Eigen::Vector3i place = lattice / edge, local = lattice - place * edge;
  return (cells[box.block_index(place)] >> (((local.x() >> 1) * 4 + (local.y() >> 1)) * 4 + (local.z() >> 1)) & 1) != 0;
}

}  // namespace

std::vector<std::vector<std::uint64_t>> solid_cells(const GridEncoder& grid, const FieldSpace& space, float min_raw) {
  std::vector<std::vector<std::uint64_t>> out;
  for (std::size_t b = 0; b < space.boxes.size(); ++b) {
    const auto& box = space.boxes[b];
    std::vector<std::uint64_t> cells(box.block_of.size(), 0);
    tbb::parallel_for(std::size_t{0}, box.places.size(), [&](std::size_t block) {
      std::uint64_t mask = 0;
      for (int bit = 0; bit < 64 && box.cells[block] != 0; ++bit) {
        if ((box.cells[block] >> bit & 1) == 0) continue;
        const int x = (bit >> 4) * 2, y = (bit >> 2 & 3) * 2, z = (bit & 3) * 2;
        bool solid = false;
        for (int k = 0; k < 27 && !solid; ++k)
          solid = grid.value_at(b, lattice_index(box, block, x + k / 9, y + k / 3 % 3, z + k % 3))(0) > min_raw;
        if (solid) mask |= std::uint64_t{1} << bit;
      }
      cells[box.block_index(box.places[block])] = mask;
    });
    out.push_back(std::move(cells));
  }
  return out;
}

FieldSpace with_cells(const FieldSpace& space, const std::vector<std::vector<std::uint64_t>>& cells) {
  FieldSpace out = space;
  for (std::size_t b = 0; b < out.boxes.size(); ++b) out.set_cells(b, cells[b]);
  return out;
}

FieldSpace with_voxel(const FieldSpace& space, const std::vector<std::uint64_t>& cells, const Region& region,
                      double voxel) {
  FieldSpace out = FieldSpace::around(region, voxel, 1);
  auto& box = out.boxes.front();
  const auto& old = space.boxes.front();
  std::vector<std::uint64_t> masks(box.block_of.size(), 0);
  tbb::parallel_for(0, box.blocks.x(), [&](int bx) {
    for (int by = 0; by < box.blocks.y(); ++by)
      for (int bz = 0; bz < box.blocks.z(); ++bz) {
        std::uint64_t mask = 0;
        for (int bit = 0; bit < 64; ++bit) {
          const Eigen::Vector3f low =
              box.min + (Eigen::Vector3i(bx, by, bz) * edge + 2 * Eigen::Vector3i(bit >> 4, bit >> 2 & 3, bit & 3))
                                .cast<float>() *
                            box.voxel;
          bool set = false;
          for (int k = 0; k < 8 && !set; ++k)
            set = cell_is_set(old, cells, low + Eigen::Vector3f(k >> 2, k >> 1 & 1, k & 1) * 1.99F * box.voxel);
          if (set) mask |= std::uint64_t{1} << bit;
        }
        masks[box.block_index({bx, by, bz})] = mask;
      }
  });
  out.set_cells(0, masks);
  return out;
}

std::unique_ptr<GridEncoder> resampled(const GridEncoder& grid, const FieldSpace& from,
                                       const std::shared_ptr<const FieldSpace>& to) {
  auto out = std::make_unique<GridEncoder>(to, grid.rates());
  for (std::size_t b = 0; b < to->boxes.size(); ++b) {
    const auto& box = to->boxes[b];
    const auto& old = from.boxes[b];
    // softplus(raw) is about exp(raw) where the field is thin.
    const float shift = std::log(box.voxel / old.voxel);
    tbb::parallel_for(std::size_t{0}, box.places.size(), [&](std::size_t block) {
      for (int voxel = 0; voxel < FieldBox::block_voxels; ++voxel) {
        const Eigen::Vector3i local(voxel >> 6, voxel >> 3 & 7, voxel & 7);
        const Eigen::Vector3f p = box.min + (box.places[block] * edge + local).cast<float>() * box.voxel;
        // A hair inwards, so that a point of both lattices is found in the block that begins there.
        const Eigen::Vector3f u = ((p - old.min) / old.voxel).array() + 1e-3F;
        const Eigen::Vector3i lattice = u.array().floor().cast<int>();
        if ((lattice.array() < 0).any() || (lattice.array() >= old.blocks.array() * edge).any()) continue;
        const Eigen::Vector3i place = lattice / edge;
        const auto old_block = old.block_of[old.block_index(place)];
        if (old_block < 0) continue;
        const Eigen::Vector3i in = lattice - place * edge;
        const Eigen::Vector3f f = (u - lattice.cast<float>()).array() - 1e-3F;
        Eigen::Array4f sum = Eigen::Array4f::Zero();
        for (int k = 0; k < 8; ++k) {
          const float weight = ((k & 4) != 0 ? f.x() : 1 - f.x()) * ((k & 2) != 0 ? f.y() : 1 - f.y()) *
                               ((k & 1) != 0 ? f.z() : 1 - f.z());
          if (weight > 1e-3F || k == 0)
            sum += weight * grid.value_at(b, lattice_index(old, static_cast<std::size_t>(old_block), in.x() + (k >> 2),
                                                           in.y() + (k >> 1 & 1), in.z() + (k & 1)));
        }
        sum(0) += shift;
        out->value(b, block, static_cast<std::size_t>(voxel)) = sum;
      }
    });
  }
  return out;
}

}  // namespace bole::plant
