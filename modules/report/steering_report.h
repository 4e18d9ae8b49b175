// The work of the stage report.steering.
#pragma once

#include "pipeline/stage.h"

namespace bole::report {

struct SteeringReportOptions {
  bool figures = true;
  double figure_width = 160;
  double dpi = 300;
};

const OptionTable& option_table(const SteeringReportOptions*);

// Writes what is connected: steering_summary.csv, steering_passes.csv, steering_errors.csv, steering_log.csv,
// steering_gains.csv, steering_tuning.csv, the error curves and report.html, into run.output_dir. What cannot be
// written becomes a warning. Throws Error{bad_input} without an output folder or anything to write, Error{cancelled}.
pipeline::StageResult write_steering_report(const DataSet& inputs, const SteeringReportOptions& options,
                                            const Run& run);

pipeline::StageType steering_report_stage();

}  // namespace bole::report
