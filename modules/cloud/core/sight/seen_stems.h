// Stems at first sight: how many, how well seen, how thick, with one wall or two.
#pragma once

#include <optional>
#include <vector>

#include "cloud/core/sight/cell_heights.h"
#include "cloud/core/sight/sample.h"
#include "cloud/first_sight.h"
#include "cloud/stem_axes.h"

namespace bole {
inline namespace cloud {
namespace sight {

// Sets stems, points_per_stem, stem_diameter_m and the doubled walls. `ground_z`: where the ground is not seen, as
// under the crown of a tree that was cut out.
void see_stems(const std::vector<StemAxis>& axes, const Sample& sample, const CellHeights& cells,
               std::optional<double> ground_z, FirstSight& out);

}  // namespace sight
}  // namespace cloud
}  // namespace bole
