// Options of the comparison of runs: those of evaluation.plot that mean something there, and its own.
#pragma once

#include "evaluation/core/evaluation_options.h"
#include "evaluation/core/same_plot.h"

namespace bole::evaluation {

struct CompareOptions : EvaluationOptions {
  double min_agreement_pct = usual_agreement_pct;
};

const OptionTable& option_table(const CompareOptions*);

}  // namespace bole::evaluation
