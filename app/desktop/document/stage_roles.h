// What a stage is for, read from its ports and options: nothing in the window knows stages by their names.
#pragma once

#include <QString>
#include <optional>
#include <string_view>

#include "pipeline/document.h"

namespace bole::desktop {

bool takes_edits(const StageType& type);  // has the list of edits that a person makes

// The first stage of the document with such a port; null when there is none.
const StageNode* stage_with_input(const PipelineDocument& document, std::string_view port);
const StageNode* stage_with_output(const PipelineDocument& document, std::string_view port);
// The stage that edits this output.
const StageNode* editor_of(const PipelineDocument& document, std::string_view port);

// Registered stages. Throw Error{failed} when there is none.
const StageType& type_with_input(std::string_view port);
const StageType& table_reader();

// The height of the slice from which diameters come, when the document has one.
std::optional<double> breast_height_m(const PipelineDocument& document);

// The title in the language of the window; the declaration has the English one.
QString stage_title(const StageType& type);

}  // namespace bole::desktop
