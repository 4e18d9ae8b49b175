// What a stage is for, read from its ports and options: nothing in the window knows stages by their names.
#pragma once

#include <optional>
#include <string_view>

#include "pipeline/document.h"

namespace bole::desktop {

inline constexpr const char* edits_option = "edits";  // the list of edits that a person makes

bool takes_edits(const pipeline::StageType& type);  // has the list of edits that a person makes

// The first stage of the document with such ports; null when there is none.
const pipeline::StageNode* stage_between(const pipeline::PipelineDocument& document, std::string_view input,
                                         std::string_view output);
const pipeline::StageNode* stage_with_output(const pipeline::PipelineDocument& document, std::string_view port);
// The stage that edits this output.
const pipeline::StageNode* editor_of(const pipeline::PipelineDocument& document, std::string_view port);

// Registered stages. Throw Error{failed} when there is none.
const pipeline::StageType& type_between(std::string_view input, std::string_view output);
const pipeline::StageType& table_reader();

// The height of the slice from which diameters come, when the document has one.
std::optional<double> breast_height_m(const pipeline::PipelineDocument& document);

}  // namespace bole::desktop
