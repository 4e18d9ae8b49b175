// Edited rows as tables.
#pragma once

#include "rows/core/edits/editable_rows.h"

namespace bole::rows {

// Rows that have other plants than before are measured anew; all others stay as `before` has them, but for their name
// and their place in the block. Given ends take precedence.
FoundRows edited_tables(const EditableRows& field, const FoundRows& before, const RowEditOptions& options,
                        const Run& run);

}  // namespace bole::rows
