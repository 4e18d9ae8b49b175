// Edits applied to the rows that were found.
#pragma once

#include "base/option.h"
#include "rows/core/edits/row_edits.h"
#include "rows/core/rows/find_rows.h"

namespace bole::rows {

struct RowEditOptions {
  std::string edits = "[]";
  std::string file;
  double match_distance = 1.0;
  double reach = 0.6;
  double angle_tolerance_deg = 2;
  LineFitMethod fit = LineFitMethod::ordinary;
};

const OptionTable& option_table(const RowEditOptions*);

struct EditedRows {
  FoundRows found;  // as find_rows gives them, with the column state (auto, edited) in `rows`
  Table log;        // edit, action, row_id, x_m, y_m, outcome (applied, conflict), message, author, time, reason
};

// `found` are the tables of find_rows. Every edit is applied by place: to the row that passes within match_distance of
// `at`. What no longer fits (no row there, two of them, an id that is taken) is a conflict: it changes nothing and is
// listed. Edited rows are measured anew, the others stay as they were but for their place in the block; a moved or
// drawn row keeps the ends that were given, its angle is theirs and has no standard error. Plants of deleted rows
// become strays. Throws Error{bad_input} for tables without the columns.
EditedRows apply_row_edits(const FoundRows& found, const std::vector<RowEdit>& edits, const RowEditOptions& options,
                           const Run& run);

}  // namespace bole::rows
