// The stem layer thinned to voxels, and what of it lies on upright surfaces.
#pragma once

#include <tbb/parallel_for.h>

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/run.h"
#include "stems/core/detect/stem_layer.h"

namespace bole::stems {

inline constexpr double thin_voxel_m = 0.02, thin_voxel_height_m = 0.05;

// Which column of voxels a place lies in, counted from the anchor of the layer.
inline std::pair<std::int64_t, std::int64_t> voxel_column(const StemLayer& layer, double x, double y) {
  return {static_cast<std::int64_t>(std::floor((x - layer.anchor.x()) / thin_voxel_m)),
          static_cast<std::int64_t>(std::floor((y - layer.anchor.y()) / thin_voxel_m))};
}

// A point of the thinned layer: the mean of the points of one voxel.
struct Voxel {
  float x = 0, y = 0, z = 0, height = 0;
  float weight = 0;  // square root of the number of points
};

// Thinned layer, by cell of the layer's grid; within a cell by slab, then by place, so that the order of the points
// does not matter.
struct VoxelLayer {
  std::vector<Voxel> voxels;
  std::vector<std::uint32_t> start;  // by cell, as StemLayer::start
};
VoxelLayer thin_layer(const StemLayer& layer, const Run& run);

// Voxels from `bottom_m` to below `top_m` above ground that lie on upright surfaces: the smallest principal axis of the
// neighbourhood, which goes beyond these heights, lies near the horizontal. Voxels with too few neighbours to tell are
// kept.
VoxelLayer upright_voxels(const StemLayer& grid, const VoxelLayer& thin, double bottom_m, double top_m, const Run& run);

// Row by row over the grid, in threads; cancelled workers stop early and the caller throws.
template <class F>
void for_each_row(const StemLayer& grid, const Run& run, F&& f) {
  tbb::parallel_for(0, grid.ny, [&](int iy) {
    if (!run.cancelled()) f(iy);
  });
  run.check_cancel();
}

}  // namespace bole::stems
