// The work of the stage report.revisit.
#pragma once

#include "pipeline/stage.h"

namespace bole::report {

struct RevisitReportOptions {
  bool figures = true;
  double figure_width = 180;
  double dpi = 300;
};

const OptionTable& option_table(const RevisitReportOptions*);

// Writes growth.csv, growth_values.csv, the map, the figure of growth and report.html into run.output_dir. What cannot
// be written becomes a finding. Throws Error{bad_input} without an output folder, Error{cancelled}.
pipeline::StageResult write_revisit_report(const DataSet& inputs, const RevisitReportOptions& options, const Run& run);

pipeline::StageType revisit_report_stage();

}  // namespace bole::report
