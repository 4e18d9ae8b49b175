// A grid on fewer or smaller voxels: what has proved empty is dropped, and detail is added where it has not.
#pragma once

#include <memory>

#include "plant/core/field/grid_encoder.h"

namespace bole::plant {

// The sampled cells in which some density is above `min_raw`, by place of each box.
std::vector<std::vector<std::uint64_t>> solid_cells(const GridEncoder& grid, const FieldSpace& space, float min_raw);

// The same boxes with only these cells.
FieldSpace with_cells(const FieldSpace& space, const std::vector<std::vector<std::uint64_t>>& cells);

// The innermost box alone, with voxels `factor` times as large (below 1: finer) where `cells` of the old one are set.
FieldSpace with_voxel(const FieldSpace& space, const std::vector<std::uint64_t>& cells, const Region& region,
                      double voxel);

// The values of a grid on another space, interpolated. Optical density per metre is kept.
std::unique_ptr<GridEncoder> resampled(const GridEncoder& grid, const FieldSpace& from,
                                       const std::shared_ptr<const FieldSpace>& to);

}  // namespace bole::plant
