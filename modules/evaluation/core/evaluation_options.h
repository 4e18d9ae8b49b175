// Options of the evaluation.
#pragma once

#include <string>

#include "base/option.h"

namespace bole::evaluation {

struct EvaluationOptions {
  double match_distance_m = 0.5;
  double dbh_gate_cm = 15;
  double class_width_cm = 5, distance_step_m = 5;
  std::string align_stems = "none";
  std::string columns, rows, reference_columns, reference_rows;
  std::string align_trajectory = "se3";
  double most_time_gap_s = 0.5;
  double rpe_step_s = 1.0;
  double segment_m = 100;
  double loop_radius_m = 3, loop_path_m = 25;
  double loop_shift_m = 0.1, loop_turn_deg = 1;
  double rpe_distance_m = 10;
  std::string published_plot = "none";
};

const OptionTable& option_table(const EvaluationOptions*);

}  // namespace bole::evaluation
