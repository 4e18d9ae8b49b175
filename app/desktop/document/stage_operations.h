// Stages added to, taken from, renamed in and copied within a document. Each function gives a changed copy and throws
// bole::Error when the result would not be a document.
#pragma once

#include <string>

#include "pipeline/document.h"

namespace bole::desktop {

// A stage of `type` behind the stage `after` (at the end when empty), joined port by port to the nearest stage before
// it that has an output of the same kind: of the same name first, of another name for inputs that must be there.
struct Added {
  pipeline::PipelineDocument document;
  std::string id;  // from the type: "stems.slice" gives slice, slice_2, ...
};
Added with_stage(const pipeline::PipelineDocument& document, const pipeline::StageType& type,
                 const std::string& after = {});

// Who took from the stage takes from what the stage took, where that has the same port; otherwise the joint goes.
pipeline::PipelineDocument without_stage(const pipeline::PipelineDocument& document, const std::string& id);

pipeline::PipelineDocument with_stage_renamed(const pipeline::PipelineDocument& document, const std::string& id,
                                              const std::string& to);

// The stage and all that take from it, once more under other ids, behind them: to try other options beside the first.
pipeline::PipelineDocument with_branch_copied(const pipeline::PipelineDocument& document, const std::string& id);

}  // namespace bole::desktop
