// Ground and noise that a person pointed out.
#pragma once

#include <cstdint>
#include <vector>

#include "ground/core/model_ground.h"
#include "ground/core/stem_feet.h"

namespace bole::ground {

// A candidate for each cell of `shape` with points whose class in `given` (by point; empty: none) is ground: the mean
// of these points. In order of cells.
std::vector<LowPoint> given_candidates(const PointCloud& cloud, const std::vector<std::uint8_t>& given,
                                       const GridShape& shape);

// The candidates once those given take the places of theirs in their cells; `feet` names both.
FootedCandidates with_given(const FootedCandidates& found, const std::vector<LowPoint>& given);

// model_ground(), or ground_of() where a terrain is given, of the points that are not given to noise, which get no
// height (NaN) and the class low noise. Points given to the ground carry the terrain and are ground. `given` by point:
// given_classes() (cloud/core/regions/point_edits.h). Throws Error{bad_input} where all points are noise, and as they
// do.
GroundModel model_edited_ground(const PointCloud& cloud, const std::vector<std::uint8_t>& given, const Raster* terrain,
                                const GroundOptions& options, const Run& run);

}  // namespace bole::ground
