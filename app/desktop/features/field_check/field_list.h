// A list of trees measured in the field: which of its columns are what, and what the options of the evaluation are
// then.
#pragma once

#include <string>
#include <vector>

#include "cloud/table.h"
#include "evaluation/core/field_columns.h"
#include "pipeline/document.h"

namespace bole::desktop {

using evaluation::field_columns;
using evaluation::FieldColumn;
using evaluation::FieldMapping;
using evaluation::guess_mapping;

// The document with the list as the reference of its evaluation; the two stages are added where they are not there.
// `align` is a choice of the option align_stems. Throws Error{bad_input} when there are no stems to evaluate.
pipeline::PipelineDocument with_field_list(const pipeline::PipelineDocument& document, const std::string& file,
                                           const FieldMapping& mapping, const std::string& align);

}  // namespace bole::desktop
