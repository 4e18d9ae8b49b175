// The work of the stage report.rows.
#pragma once

#include "pipeline/stage.h"

namespace bole::report {

struct RowsReportOptions {
  bool figures = true;
  double figure_width = 180;
  double dpi = 300;
};

const OptionTable& option_table(const RowsReportOptions*);

// Writes rows.csv, plants.csv, strays.csv, edits.csv, rows.gpkg, rows.geojson, ab_lines.geojson, row_matches.csv, the
// figures and report.html into run.output_dir. What cannot be written becomes a warning. Throws Error{bad_input}
// without an output folder, Error{cancelled}.
pipeline::StageResult write_rows_report(const DataSet& inputs, const RowsReportOptions& options, const Run& run);

pipeline::StageType rows_report_stage();

}  // namespace bole::report
