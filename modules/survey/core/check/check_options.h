// Options of the check of a map: what counts as covered, sharp and level, and which trees of the boundary are in.
#pragma once

#include <array>
#include <string_view>

#include "base/option.h"

namespace bole::survey {

// Which trees at the boundary are in the plot.
//   centre: the centre at breast height (as survey.plot counts).   base: the centre of the foot.
//   whole: the whole stem at breast height.   any_part: any part of the stem at breast height.
//   half: any part on the southern and western edges, only the whole stem on the others, so that plots side by side
//         count each tree once.
enum class BoundaryRule { centre, base, whole, any_part, half };
constexpr std::array<std::string_view, 5> choice_names(BoundaryRule) {
  return {"centre", "base", "whole", "any_part", "half"};
}

struct CheckOptions {
  double cell = 1.0;
  int min_ground_points = 3;
  double max_unseen_pct = 2.0;
  double walk_again_unseen_pct = 10.0;
  double max_hole_m2 = 6.0;
  double max_walk_gap = 4.0;
  double min_view_span_deg = 90.0;
  double max_one_sided_pct = 10.0;
  double min_density_pct = 5.0;
  double max_pass_spread_cm = 3.0;
  double walk_again_spread_cm = 10.0;
  double max_wall_cm = 2.0;
  double max_length_error_pct = 0.05;
  double max_loop_residual = 0.10;
  double max_loop_turn_deg = 1.0;
  double max_tilt_deg = 1.0;
  int targets = 2;
  double target_distance = 0.0;
  double target_tolerance = 0.05;
  BoundaryRule boundary_rule = BoundaryRule::centre;
  double position_se_cm = 2.0;
  double max_doubtful_pct = 5.0;
  double min_missed_dbh_cm = 10.0;
  double max_without_ground_pct = 10.0;
};

const OptionTable& option_table(const CheckOptions*);

}  // namespace bole::survey
