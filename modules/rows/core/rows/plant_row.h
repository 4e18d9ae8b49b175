// One row: its plants in order and numbered, its course, and the places where a plant is missing.
#pragma once

#include <vector>

#include "rows/core/rows/line_fit.h"
#include "rows/core/rows/row_chains.h"
#include "rows/core/rows/row_curve.h"

namespace bole::rows {

struct MissingPlant {
  int number = 0;
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
};

struct PlantRow {
  int block = 0;             // from 1
  std::vector<int> plants;   // indices, in the order of the row
  std::vector<int> numbers;  // of the plants, from 1, places of missing plants counted
  std::vector<MissingPlant> missing;
  RowCurve curve;
  LineFit line;             // by the option `fit`
  double spacing_m = 0;     // of neighbouring places; NaN for one plant
  double spacing_sd_m = 0;  // scatter of the plants about even places
  bool even = true;         // the spacing is even enough to tell where plants are missing
};

struct RowAssembly {
  PlantRow row;
  std::vector<int> strays;  // of the chain: beside the row, or between its places
};

// A row from a chain of plants. Plants beside its course are dropped (more than 4.5 robust sigmas, at least a tenth of
// the spacing), and of two at one place the one that fits worse, unless `keep_all`. `spacing_m` is the start for the
// spacing of the row.
RowAssembly assemble_row(const Points2& plants, const Chain& chain, double spacing_m, const RowOptions& options,
                         bool keep_all);

}  // namespace bole::rows
