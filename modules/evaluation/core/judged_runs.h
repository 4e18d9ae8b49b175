// Runs and pairs of runs with what their comparison found.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "evaluation/core/compare_runs.h"
#include "evaluation/core/compared_run.h"
#include "evaluation/core/comparison_rows.h"
#include "evaluation/core/evaluate_stems.h"

namespace bole::evaluation {

// One run on its way through the comparison.
struct JudgedRun {
  ComparedRun run;
  std::optional<StemEvaluation> evaluation;  // against its reference
  PathErrors path;
  bool agrees = true;  // with its reference
};

struct JudgedPair {
  std::size_t first = 0, second = 0;
  StemEvaluation stems;
  PathErrors path;
};

// The tables of a comparison, its counts, message and the findings on what could be compared. `out.report` may hold
// findings already.
void fill_comparison(const std::vector<JudgedRun>& runs, const std::vector<JudgedPair>& pairs, RunsComparison& out);

}  // namespace bole::evaluation
