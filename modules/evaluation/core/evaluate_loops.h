// Revisits that a SLAM run found, held against the reference trajectory.
#pragma once

#include "cloud/table.h"
#include "cloud/trajectory.h"
#include "evaluation/core/evaluation_options.h"

namespace bole::evaluation {

struct LoopEvaluation {
  Table summary;  // measure, value, unit, published
  // The input with distance_m between the two places in the reference and `right` (0, 1); where it has relative poses
  // also their errors shift_error_m, turn_error_deg and `true_pose` (0, 1).
  Table loops;
  std::size_t found = 0, right = 0, wrong = 0;
  std::size_t true_poses = 0;  // 0 too where the input has no relative poses
};

// `loops` has from_time_s and to_time_s, and may have the pose of the later sensor in the axes of the earlier one: x_m,
// y_m, z_m, qx, qy, qz, qw.
// Place: a loop is right when the reference puts its two places no farther apart than loop_radius. Pose: its relative
// pose is true when it agrees with that of the reference within loop_shift and loop_turn, wherever the two places are.
// A chance is a place, taken every metre of the way, that lies within loop_radius of an earlier one from which the way
// is at least loop_path; it is used when a right loop ends within loop_radius of way from it. Precision (of places, of
// poses) is the share of right (true) ones among the loops found, recall the share of chances that were used. Throws
// Error{bad_input} where columns are missing.
LoopEvaluation evaluate_loops(const Table& loops, const Trajectory& reference, const EvaluationOptions& options);

}  // namespace bole::evaluation
