// The work of the stage report.steering.
#pragma once

#include "pipeline/stage.h"

namespace bole {

struct SteeringReportOptions {
  bool figures = true;
  double figure_width = 180;
  double dpi = 200;
};

const OptionTable& option_table(const SteeringReportOptions*);

// Writes the tables that are connected as CSV, tracking error curves, and steering.html into run.output_dir. What
// cannot be written becomes a warning. Throws Error{bad_input} without an output folder or without any input,
// Error{cancelled}.
StageResult write_steering_report(const DataSet& inputs, const SteeringReportOptions& options, const Run& run);

StageType steering_report_stage();

}  // namespace bole
