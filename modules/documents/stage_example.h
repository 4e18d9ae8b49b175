// How a stage is used, for its page of the manual.
#pragma once

#include <string>

#include "pipeline/stage.h"

namespace bole::documents {

// Markdown: the stage as the first pipeline that comes with Bole has it, and one of its options on the command line and
// in Python. Where none has it, a stage to copy whose inputs are to be joined.
std::string stage_example(const pipeline::StageType& type);

}  // namespace bole::documents
