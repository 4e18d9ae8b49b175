// The comparison of runs as files: tables, figures and a page.
#pragma once

#include <optional>

#include "pipeline/stage.h"

namespace bole::report {

struct CompareReportOptions {
  std::string title = "Comparison of runs";
  bool figures = true, cloud_figures = true;
  double figure_width = 170, dpi = 200;
  int slices = 4;
  std::optional<double> enlarge;
};
const OptionTable& option_table(const CompareReportOptions*);

// Writes comparison.json, runs.csv, positions.csv, diameters.csv, detection.csv, trajectories.csv, pairs.csv,
// compared_trees.csv, figures and report.html into run.output_dir. What cannot be written becomes a finding.
pipeline::StageResult write_compare_report(const DataSet& inputs, const CompareReportOptions& options, const Run& run);

pipeline::StageType compare_report_stage();

}  // namespace bole::report
