// Circles in horizontal slabs of the stem layer: the raw material of detection.
#pragma once

#include <vector>

#include "base/run.h"
#include "stems/core/detect/voxel_layer.h"
#include "stems/core/stem_options.h"

namespace bole::stems {

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

// Where the highest slab ends: search_top, to a whole number of slabs.
double slabs_top_m(const MeasureOptions& options);

// Circles of every slab between search_bottom and search_top, by a randomised search around each voxel of the thinned
// layer and suppression of overlapping weaker circles.
std::vector<SlabCircle> find_slab_circles(const StemLayer& grid, const VoxelLayer& thin, const MeasureOptions& options,
                                          const Run& run);

}  // namespace bole::stems
