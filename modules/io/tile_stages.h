// Stages for clouds that are worked on in tiles.
#pragma once

#include "pipeline/stage.h"

namespace bole::io {

void register_tiles(pipeline::StageRegistry& registry);

}  // namespace bole::io
