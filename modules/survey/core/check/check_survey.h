// The check of a whole map before somebody signs it.
#pragma once

#include "base/report.h"
#include "survey/core/check/check_grid.h"
#include "survey/core/check/check_options.h"

namespace bole::survey {

struct SurveyCheck {
  Table findings;  // code, severity, text, x_m, y_m, distance_m, bearing_deg; facts verdict, not_judged
  Table cells;     // of the region: x_m, y_m and the measures; facts cell_m, columns without a value are left out
  Table stems;     // x_m, y_m, wall_cm, pass_spread_cm of each stem of the region; row of the stem table
  Table boundary;  // trees on the boundary, see judge_map.h
  Report report;
};

// Throws Error{bad_input} where there is neither a cloud nor a stem table.
SurveyCheck check_survey(const CheckInputs& inputs, const CheckOptions& options, const Run& run);

}  // namespace bole::survey
