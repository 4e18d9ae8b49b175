// Rows beside reference rows (SPEC B, figures 8 and 10).
#pragma once

#include "cloud/point_cloud.h"
#include "cloud/table.h"
#include "render/draw/figure.h"

namespace bole::render {

struct RowTruth {
  const Table* plants = nullptr;           // row_id, x_m, y_m, state
  const Table* lines = nullptr;            // vertices: row_id, x_m, y_m
  const Table* reference = nullptr;        // plants: x_m, y_m, state where known
  const Table* reference_lines = nullptr;  // vertices: row_id, x_m, y_m
  const Table* matches = nullptr;  // kind, row_id, ref_id, angle_deg, ref_angle_deg, angle_error_deg of each row
  bool north_known = true;
};

// Two panels on the same axes: a the plants and rows that were found, b those of the reference. Copies what it draws.
Figure rows_and_reference(const RowTruth& truth, double width_mm);

// One plan with both over each other. A cloud is panel a, seen from the side in its own axes, and the plan is panel b
// beside it; `cloud` may be null.
Figure rows_over_reference(const RowTruth& truth, const PointCloud* cloud, double width_mm);

}  // namespace bole::render
