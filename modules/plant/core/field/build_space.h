// The space of a field for given views.
#pragma once

#include "plant/core/field/field_options.h"
#include "plant/core/field/field_space.h"
#include "plant/core/field/mask_hull.h"
#include "plant/core/surface/posed_views.h"

namespace bole::plant {

// Blocks that the memory holds.
double max_blocks(const FieldOptions& options);

// The region of the options, or what they say is found as it.
Region field_region(const ViewSource& views, const std::vector<PosedView>& posed, const FieldOptions& options,
                    const Run& run, Report& report);

// Boxes around the region with the cells near measured depth; without depth one box with the cells that the masks leave
// to the object, or all. Voxels are enlarged where the memory is not enough, with a warning. Throws Error{bad_input}
// where no depth lies in the region.
FieldSpace build_space(const ViewSource& views, const std::vector<PosedView>& posed, const MaskHull& hull,
                       const Region& region, const FieldOptions& options, const Run& run, Report& report);

}  // namespace bole::plant
