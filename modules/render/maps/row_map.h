// The row map: guidance lines, plants, and the places where one is missing.
#pragma once

#include "cloud/table.h"
#include "render/draw/figure.h"

namespace bole::render {

struct RowMapData {
  const Table* rows = nullptr;    // row_id
  const Table* plants = nullptr;  // x_m, y_m, state (present, missing)
  const Table* lines = nullptr;   // row_id, x_m, y_m: vertices, those of a row one after the other
  const Table* strays = nullptr;  // x_m, y_m
  bool north_known = true;        // y points north
};

// Copies what it draws: the data may go away afterwards. Its height follows from the extent of the field.
Figure row_map(const RowMapData& data, double width_mm);

}  // namespace bole::render
