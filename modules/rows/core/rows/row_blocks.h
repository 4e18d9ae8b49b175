// Rows that belong together: side by side and in one direction.
#pragma once

#include <vector>

#include "rows/core/rows/plant_row.h"

namespace bole::rows {

struct RowBlock {
  double angle_rad = 0;           // mean direction of its rows, in (-pi/2, pi/2]
  std::vector<int> rows;          // indices of rows, from left to right looking along the direction
  std::vector<double> to_next_m;  // distance of each row to the next, NaN for the last
};

// Groups rows that run side by side (directions within 15 degrees, not further apart than 1.7 row spacings, side by
// side over a good part). `row_spacing_m[i]` is that about row i, infinite when unknown. Blocks come in order of their
// centres, from west to east, then from south to north.
std::vector<RowBlock> find_blocks(const std::vector<PlantRow>& rows, const Points2& plants,
                                  const std::vector<double>& row_spacing_m);

}  // namespace bole::rows
