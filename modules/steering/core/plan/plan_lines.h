// Guidance lines from A, B and the width of the implement; headlands (SPEC E5).
#pragma once

#include <optional>

#include "base/option.h"
#include "base/report.h"
#include "base/run.h"
#include "cloud/table.h"

namespace bole::steering {

struct PlanOptions {
  std::optional<double> width;  // none: the line through A and B alone
  double overlap = 0;
  int lines_left = 10;
  int lines_right = 0;
  int headland_passes = 2;
  double min_length = 5;
};
const OptionTable& option_table(const PlanOptions*);

struct LinePlan {
  // A row per piece of a line: line (0 through A and B, 1 the next to its left, -1 to its right, ...), part (from 1,
  // where the boundary cuts a line), a_x_m, a_y_m, b_x_m, b_y_m, length_m; all from A towards B. Facts row_width_m
  // (width less overlap, where a width is given), axes and crs.
  Table lines;
  // Vertices of the headlands: headland (from 1), ring (outer, inner), number, x_m, y_m. The last vertex does not
  // repeat the first.
  Table headlands;
  Report report;
};

// `ab`: one row with a_x_m, a_y_m, b_x_m, b_y_m, or two rows with x_m, y_m (A first, or named A and B). `boundary`:
// x_m, y_m, the corners of the field in order. With a boundary the lines fill the field and end at the headland, which
// is a ring of headland_passes widths along the boundary. Without one they run from A to B, lines_left and lines_right
// of them beside it, and the headlands lie beyond both ends. Throws Error{bad_input} when A and B are missing or the
// same place, the boundary is no polygon or crosses itself, the field is all headland, or the planes differ.
LinePlan plan_lines(const Table& ab, const Table* boundary, const PlanOptions& options, const Run& run);

}  // namespace bole::steering
