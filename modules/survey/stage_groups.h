// The stages of this module, in groups that have a file each.
#pragma once

#include "pipeline/stage.h"

namespace bole::survey {

void register_georeference(pipeline::StageRegistry& registry);
void register_check(pipeline::StageRegistry& registry);
void register_revisit(pipeline::StageRegistry& registry);

}  // namespace bole::survey
