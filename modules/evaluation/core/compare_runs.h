// Two or more runs compared with a reference and with each other: the figures of tables 2 and 3 of the paper on forest
// plots (SPEC A11), run by run and pooled.
#pragma once

#include <optional>
#include <vector>

#include "base/report.h"
#include "base/run.h"
#include "evaluation/core/compare_options.h"
#include "evaluation/core/compared_run.h"

namespace bole::evaluation {

struct RunsComparison {
  Table runs;    // run, name, plot, system, agrees (0, 1): of each run, with the plot that it was found to be of
  Table groups;  // comparison_table() of runs and pooled rows; empty without a reference
  Table pairs;   // comparison_table() of each two runs of a plot: the later one minus the earlier
  // The trees of the rows `run`, or without any reference those of each run against the first of its plot: run, name,
  // plot, system, against ("reference" or a name), and the columns of StemEvaluation::matches with dbh_lo_cm,
  // dbh_hi_cm.
  Table trees;
  Report report;
};

// `reference` and `reference_trajectory` replace those that the runs carry. Runs without a plot of their own share one
// where min_agreement_pct of the stems of the smaller list agree. A run whose stems agree with the reference less than
// that keeps its row and is left out of pooled rows, with the reason as a finding. Throws Error{bad_input} for tables
// without positions or diameters, Error{cancelled}.
RunsComparison compare_runs(std::vector<ComparedRun> runs, const std::optional<Table>& reference,
                            const Trajectory* reference_trajectory, const CompareOptions& options, const Run& run);

}  // namespace bole::evaluation
