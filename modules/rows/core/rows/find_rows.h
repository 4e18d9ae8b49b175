// From stems to rows.
#pragma once

#include "base/report.h"
#include "base/run.h"
#include "cloud/table.h"
#include "rows/core/rows/row_options.h"

namespace bole::rows {

struct FoundRows {
  Table rows;    // one line per row, see README.md
  Table plants;  // row_id, number, x_m, y_m, state (present, missing), across_m, tree_id where the stems have one
  Table lines;   // row_id, number, x_m, y_m: vertices of the guidance lines, two for a straight row
  Table strays;  // stems in no row: x_m, y_m, tree_id where the stems have one
  Report report;
};

// The rows of a block or of several, of any direction, straight or curved. `stems` has x_m and y_m; with a column
// row_id the assignment is that of the column (an empty cell: a stray), and only course, order and places are found.
// Stems without coordinates are left out with a warning. Throws Error{bad_input} for a table without the columns or
// without a stem that has coordinates.
FoundRows find_rows(const Table& stems, const RowOptions& options, const Run& run);

}  // namespace bole::rows
