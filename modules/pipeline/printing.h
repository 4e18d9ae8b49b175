// Texts printed from the declarations of stages: the only source of pages, schemas and lists.
#pragma once

#include <string>
#include <string_view>

#include "pipeline/stage.h"

namespace bole::pipeline {

// The manual page of a stage (docs/stages/<type>.md). `example` stands at its end: what pipelines have the stage is
// known above this module.
std::string stage_markdown(const StageType& type, std::string_view example = {});
// The index of docs/stages.
std::string stages_index_markdown(const StageRegistry& registry);
// The page of the per-point arrays (docs/stages/arrays.md).
std::string arrays_markdown();
// All stages with ports and options, for tools.
std::string stages_json(const StageRegistry& registry);
// A JSON schema (draft 2020-12) of pipeline documents.
std::string document_schema(const StageRegistry& registry);
// A table of options for the terminal.
std::string options_text(const OptionTable& table);
// The values that a run with these options uses, for the terminal; those that a run with default options does not use
// are marked.
std::string values_in_force_text(const StageType& type, const OptionSet& options);

}  // namespace bole::pipeline
