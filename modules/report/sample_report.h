// The work of the stage report.sample.
#pragma once

#include "pipeline/stage.h"

namespace bole::report {

struct SampleReportOptions {
  bool figures = true;
  double figure_width = 160;
  double dpi = 300;
};

const OptionTable& option_table(const SampleReportOptions*);

// Writes sample_summary.csv, sample_plots.csv, the curves and report.html into run.output_dir. What cannot be written
// becomes a warning. Throws Error{bad_input} without an output folder, Error{cancelled}.
pipeline::StageResult write_sample_report(const DataSet& inputs, const SampleReportOptions& options, const Run& run);

pipeline::StageType sample_report_stage();

}  // namespace bole::report
