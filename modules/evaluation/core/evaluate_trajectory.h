// A trajectory held against a reference.
#pragma once

#include <vector>

#include "cloud/table.h"
#include "cloud/trajectory.h"
#include "evaluation/core/evaluation_options.h"

namespace bole::evaluation {

struct TrajectoryEvaluation {
  Table summary;  // measure, value, unit, published
  Table errors;   // time_s, x_m, y_m, z_m (reference), error_m, error_x_m, error_y_m, error_z_m, rotation_error_deg
  Pose T_reference_estimate = Pose::Identity();  // the alignment
  std::size_t poses = 0;
};

// Every estimated pose is compared with the reference interpolated to its time. ATE: position error after the best
// rigid motion (Umeyama 1991 without scale) or none. RPE: error of the motion over rpe_step seconds, over
// rpe_distance of way (and by how much these steps are too long as a whole), and of KITTI's segments where the path is
// long enough. Drift: error of the end point after the start poses are made equal, by length walked. Throws
// Error{bad_input} when fewer than three poses overlap in time.
TrajectoryEvaluation evaluate_trajectory(const Trajectory& estimate, const Trajectory& reference,
                                         const EvaluationOptions& options);

}  // namespace bole::evaluation
