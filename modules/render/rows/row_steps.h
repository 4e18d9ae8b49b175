// The steps from one frame to its rows on a sheet of six panels (SPEC B, figure 7).
#pragma once

#include "cloud/point_cloud.h"
#include "cloud/table.h"
#include "render/draw/figure.h"

namespace bole::render {

// The outputs of the steps. Clouds and centres are in the axes of the levelled frame: x right, y ahead, z up.
struct RowSteps {
  const PointCloud* region = nullptr;
  const PointCloud* cleaned = nullptr;   // without ground and lone points
  const PointCloud* clusters = nullptr;  // with the column plant
  const PointCloud* trunks = nullptr;    // with the column plant
  const Table* centres = nullptr;        // x_m, y_m
  const Table* plants = nullptr;         // in their rows, as `lines` in the axes of the rows
  const Table* lines = nullptr;          // vertices: row_id, x_m, y_m
  bool north_known = true;               // y of the rows points north

  bool complete() const {
    return region != nullptr && cleaned != nullptr && clusters != nullptr && trunks != nullptr && centres != nullptr &&
           plants != nullptr && lines != nullptr;
  }
};

// a: the region; b: ground and lone points removed; c: clusters; d: points of trunks; e: their centres in the plan;
// f: the fitted rows. Copies what it draws. Throws Error{bad_input} where a step is missing.
Figure row_steps_sheet(const RowSteps& steps, double width_mm);

}  // namespace bole::render
