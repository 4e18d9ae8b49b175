// The figures of a report on rows.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "cloud/table.h"
#include "pipeline/stage.h"
#include "render/draw/figure.h"

namespace bole::report {

struct RowsFigure {
  std::string what;  // for messages
  std::function<render::Figure()> make;
};

// The inputs of report.rows that only figures use: the steps of one frame (region, cleaned, clusters, trunks, centres)
// and the reference (reference, reference_lines, matches). All optional.
std::vector<pipeline::Port> rows_figure_ports();

// The row map; the sheet of the steps where all of them are connected; the rows beside and over the reference where
// there is one. Keeps references to the inputs.
std::vector<RowsFigure> rows_figures(const DataSet& inputs, double width_mm);

}  // namespace bole::report
