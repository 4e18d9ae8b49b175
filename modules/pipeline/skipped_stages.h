// Which stages of a document have nothing to do.
#pragma once

#include "pipeline/document.h"

namespace bole::pipeline {

// A stage marked "optional": true is skipped while an input path of it is empty, and while one that it takes a required
// input from is skipped: the projection of a list of marks has nothing to do without the list.
bool is_skipped(const PipelineDocument& document, const StageNode& node);

}  // namespace bole::pipeline
