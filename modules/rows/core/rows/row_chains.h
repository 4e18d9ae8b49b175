// Plants strung together into rows.
#pragma once

#include <vector>

#include "base/run.h"
#include "rows/core/rows/local_pattern.h"

namespace bole::rows {

using Chain = std::vector<int>;  // indices of plants in the order of the row

// Grows chains from the plants with the clearest direction on: the next plant is looked for ahead along the chain's own
// last stretch, over up to max_gap missing plants, and where several offer, that which keeps line and spacing. Chains
// that lead into one another are joined. Plants that fit nowhere are in no chain.
std::vector<Chain> grow_chains(const Points2& plants, const PlantGrid& grid, const std::vector<LocalPattern>& patterns,
                               const RowOptions& options, const Run& run);

}  // namespace bole::rows
