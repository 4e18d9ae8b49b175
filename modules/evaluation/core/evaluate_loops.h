// Revisits that a SLAM run found, held against the reference trajectory.
#pragma once

#include "cloud/table.h"
#include "cloud/trajectory.h"
#include "evaluation/core/evaluation_options.h"

namespace bole {

struct LoopEvaluation {
  Table summary;  // measure, value, unit, published
  Table loops;    // the input with distance_m between the two places in the reference, and `right` (0, 1)
  std::size_t found = 0, right = 0, wrong = 0;
};

// `loops` has from_time_s and to_time_s. A loop is right when the reference puts its two places no farther apart than
// loop_radius. A chance is a place, taken every metre of the way, that lies within loop_radius of an earlier one from
// which the way is at least loop_path; it is used when a right loop ends within loop_radius of way from it. Precision
// is the share of right loops, recall the share of chances that were used. Throws Error{bad_input} where columns are
// missing.
LoopEvaluation evaluate_loops(const Table& loops, const Trajectory& reference, const EvaluationOptions& options);

}  // namespace bole
