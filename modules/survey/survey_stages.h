// The stages of this module, in groups that have a file each.
#pragma once

#include "pipeline/stage.h"

namespace bole::survey {

// The axes of a plot: of the first of the inputs points and stems that says so.
Axes axes_of(const DataSet& inputs);

void register_georeference(pipeline::StageRegistry& registry);
void register_check(pipeline::StageRegistry& registry);
void register_revisit(pipeline::StageRegistry& registry);

}  // namespace bole::survey
