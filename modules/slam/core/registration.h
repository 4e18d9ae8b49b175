// One frame against a map: robust point-to-plane and point-to-line least squares over a rigid shift of the frame, or over its
// begin and end pose.
#pragma once

#include "base/run.h"
#include "slam/core/distribution_map.h"
#include "slam/core/features.h"
#include "slam/core/motion.h"

namespace bole {

using Matrix6d = Eigen::Matrix<double, 6, 6>;

// What the features of a frame are registered against: edges to lines of one map, planes to planes of the other.
struct FeatureMaps {
  explicit FeatureMaps(double cell_m) : edges(cell_m), planes(cell_m) {}
  DistributionMap edges, planes;
  void clear() { edges.clear(), planes.clear(); }
};

// One matched point: the quadratic form e^T weight e of the error e = x - target, weight already robust and in 1/m^2.
struct Match {
  Eigen::Vector3d target;
  Eigen::Matrix3d weight;
  double squared = 0;  // squared normalised residual before the robust weight
  bool inlier = false;
};

// The part of a point's error that the surface about it determines: along the normal of a plane, across the direction of a line.
struct MatchModel {
  double sigma_m = 0.02;  // of a range
  double kernel = 3;      // Geman-McClure scale in standard deviations
  int first_level = 0;
};
// Empty when there is nothing plane (line-like when `line`) about the place.
std::optional<Match> match_point(const DistributionMap& map, const Eigen::Vector3d& point_in_map, bool line, const MatchModel& model);

// Normal equations of one pose: unknowns are a small turn about the sensor (rad, map axes) and a shift of it (m).
// error(x) = point - target, d(point)/d(turn) = -[lever]x.
void add_pose_equations(const Eigen::Vector3d& lever, const Eigen::Vector3d& error, const Eigen::Matrix3d& weight, Matrix6d& H, Vector6d& g);

enum class MotionModel {
  rigid,   // the motion within the frame is kept, the frame is moved as a whole: 6 unknowns
  end,     // the begin pose stands, the end pose is sought: 6 unknowns
  elastic  // begin and end pose, held by continuity and smoothness: 12 unknowns
};

struct RegistrationSettings {
  MotionModel model = MotionModel::rigid;
  int rounds = 12;
  int coarse_rounds = 3;  // rounds that start on coarser levels and with a wider kernel
  double sigma_m = 0.02;
  double kernel_sigmas = 3;
  // Elastic: standard deviations of the begin against the prediction, and of the motion over the frame against it.
  double begin_sigma_m = 0.004, begin_sigma_rad = 0.001;
  double motion_sigma_m = 0.05, motion_sigma_rad = 0.02;
  double converged_m = 2e-4, converged_rad = 2e-5;
};

struct Registration {
  FrameMotion motion;
  int rounds = 0;
  bool converged = false;
  std::size_t tried = 0, matched = 0, inliers = 0;
  double overlap = 0;                       // inliers / tried
  double rms_m = 0;                         // of the inliers, along their normals
  Matrix6d information = Matrix6d::Zero();  // of the end pose (turn, shift), data only
  double conditioning = 0;                  // least over largest eigenvalue of the shift part, turn eliminated
};

// `guess` is where the search starts; for MotionModel::elastic also the prediction that the priors hold to.
// Throws Error{cancelled}.
Registration register_frame(const FeatureSet& features, const FeatureMaps& maps, const FrameMotion& guess, const RegistrationSettings& settings, const Run& run);

}  // namespace bole
