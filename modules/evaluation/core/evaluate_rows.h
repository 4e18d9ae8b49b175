// Plant rows held against reference rows.
#pragma once

#include "cloud/table.h"
#include "evaluation/core/evaluation_options.h"

namespace bole::evaluation {

struct RowEvaluation {
  Table summary;  // measure, value, unit, published
  Table rows;     // kind (matched, missed, false), row_id, ref_id, angle_deg, ref_angle_deg, angle_error_deg, shared
  Table reference_lines;  // row_id, x_m, y_m: the ends of each reference row, its least-squares line where it is plants
};

// Two kinds of tables are told by their columns.
// Plants (row_id, x_m, y_m; state = present where there is one): plants within match_distance of one another are the
// same. A row is right when 90 % of its plants are of one reference row and it has 90 % of those; recall and precision
// of rows, the share of plants in their row, the share of missing plants (state = missing) listed within
// match_distance, and angle errors of the rows by least squares. Lines (row_id, x0_m, y0_m, x1_m, y1_m): rows match one
// to one when their directions differ by less than 15 degrees and the middle of the reference row lies within
// match_distance of the line and between its ends; angle errors. Angles are those of angle_deg where both have it.
// Throws Error{bad_input} for other tables, or for two of different kinds.
RowEvaluation evaluate_rows(const Table& estimate, const Table& reference, const EvaluationOptions& options);

}  // namespace bole::evaluation
