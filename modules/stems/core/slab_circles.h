// Circles in horizontal slabs of the stem layer: the raw material of detection.
#pragma once

#include <vector>

#include "base/run.h"
#include "stems/core/stem_layer.h"
#include "stems/core/stem_options.h"

namespace bole {

struct SlabCircle {
  double x = 0, y = 0, radius = 0;  // offsets from the cloud's origin, metres
  double height = 0;                // mean height above ground of its points, metres
  double z = 0;                     // their mean z
  double score = 0;                 // weight of the points on the circle less that of points inside
  double arc_rad = 0;
  int slab = 0;
  int points = 0;
};

inline constexpr double slab_thickness_m = 0.25;

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

// Keeps voxels on upright surfaces: the smallest principal axis of the neighbourhood lies near the horizontal. Voxels
// with too few neighbours to tell are kept.
void keep_upright(const StemLayer& grid, VoxelLayer& thin, const Run& run);

// Circles of every slab between search_bottom and search_top, by a randomised search around each voxel and suppression
// of overlapping weaker circles.
std::vector<SlabCircle> find_slab_circles(const StemLayer& grid, const VoxelLayer& thin, const MeasureOptions& options,
                                          const Run& run);

}  // namespace bole
