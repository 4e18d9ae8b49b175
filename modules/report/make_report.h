// The report stage's work.
#pragma once

#include "pipeline/stage.h"
#include "report/report_options.h"

namespace bole::report {

// Writes data files, figures and report.html into run.output_dir. What cannot be written or drawn is a finding of the
// report (output_not_written) and does not keep the rest from being written. Asked to finish early it leaves out the
// figures that are not drawn yet. Throws Error{bad_input} without an output folder, Error{cancelled}.
pipeline::StageResult make_report(const DataSet& inputs, const ReportOptions& options, const Run& run);

// Adds the stages report.plot and report.rows.
void register_stages(pipeline::StageRegistry& registry);

}  // namespace bole::report
