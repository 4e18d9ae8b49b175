// One frame against a map: robust point-to-plane and point-to-line least squares over a rigid shift of the frame, or
// over its begin and end pose.
#pragma once

#include <optional>

#include "base/run.h"
#include "slam/core/map/distribution_map.h"
#include "slam/core/odometry/features.h"
#include "slam/core/odometry/motion.h"
#include "slam/core/odometry/priors.h"

namespace bole::slam {

// What the features of a frame are registered against: edges to lines of one map, planes to planes of the other.
struct FeatureMaps {
  explicit FeatureMaps(double cell_m) : edges(cell_m), planes(cell_m) {}
  DistributionMap edges, planes;
  void clear() { edges.clear(), planes.clear(); }
};

// Which points of the map make the surface about a place: those of the eight cells nearest to it, or of the one cell
// that holds it. The first reaches farther. But a window that moves with the place lies behind every point of a convex
// surface: its mean is within the bark, and all points are drawn towards what they show, by 5 mm on trunks with cells
// of 0.1 m. In fixed cells, where the points are those that make the mean, these pulls cancel.
enum class CellChoice { about, cell };

// What a point is held to: the normal distance to a plane, or the distance to a line.
struct Target {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  // normal of the plane, direction of the line
  double variance_m2 = 1;                           // thickness of the surface and scatter of the range
  double leverage = 0;  // how much the scatter of the surface's points moves it at the place, 0 to 1
  enum class Kind : std::uint8_t { none, plane, line } kind = Kind::none;
};

// The surface about the place that is plane (or line) enough, on the finest level from `first_level` that has one made
// of at least so many scan lines.
std::optional<LocalSurface> find_surface(const DistributionMap& map, const Eigen::Vector3d& point_in_map, bool line,
                                         int first_level, int least_lines = 0, CellChoice window = CellChoice::about);
Target as_target(const LocalSurface& surface, bool line, double sigma_m);
// Both in one; Kind::none where there is none.
Target find_target(const DistributionMap& map, const Eigen::Vector3d& point_in_map, bool line, int first_level,
                   double sigma_m, CellChoice window = CellChoice::about);

// Normal equations of one pose: the unknowns are a small turn about the sensor (rad, map axes) and a shift of it (m),
// and d(point)/d(turn) = -[lever]x with `lever` the point less the sensor's position.
struct PoseEquations {
  Matrix6d H = Matrix6d::Zero();
  Vector6d g = Vector6d::Zero();
  double squared_m2 = 0;  // squared distance to the target
  double weight = 0;      // 1 / m2, kernel included
  bool inlier = false;    // within the kernel
};
// Weighted by the variance of the target and the Geman-McClure kernel of `kernel` standard deviations.
PoseEquations pose_equations(const Target& target, const Eigen::Vector3d& point_in_map, const Eigen::Vector3d& lever,
                             double kernel);

enum class MotionModel {
  rigid,   // the motion within the frame is kept, the frame is moved as a whole: 6 unknowns
  end,     // the begin pose stands, the end pose is sought: 6 unknowns
  elastic  // begin and end pose, held by continuity and smoothness: 12 unknowns
};

struct RegistrationSettings {
  MotionModel model = MotionModel::rigid;
  int rounds = 12;
  int coarse_rounds = 2;  // rounds that start on coarser levels and with a wider kernel
  double sigma_m = 0.02;
  double kernel_sigmas = 3;
  // Planes give height, roll and pitch, lines the rest (rigid only): Shan and Englot 2018.
  bool two_step = false;
  std::optional<AdjustmentPriors> priors;  // instead of sigma_m
  // Elastic: standard deviations of the begin against the prediction, and of the motion over the frame against it.
  double begin_sigma_m = 0.004, begin_sigma_rad = 0.001;
  double motion_sigma_m = 0.05, motion_sigma_rad = 0.02;
  double converged_m = 5e-4, converged_rad = 5e-5;
};

struct Registration {
  FrameMotion motion;
  int rounds = 0;
  bool converged = false;  // the last step was below converged_m and converged_rad; else the rounds ran out
  std::size_t tried = 0, matched = 0, inliers = 0;
  double overlap = 0;                       // inliers / tried
  double rms_m = 0;                         // of the inliers, along their normals
  Matrix6d information = Matrix6d::Zero();  // of the end pose (turn, shift), data only
  double conditioning = 0;                  // least over largest eigenvalue of the shift part, turn eliminated
  // Of unit weight, 1 when the weights are right; and sigma0^2 information^-1 (turn rad, shift m; map axes).
  double sigma0 = 0;
  Matrix6d covariance = Matrix6d::Zero();
};

// `guess` is where the search starts; for MotionModel::elastic also the prediction that the priors hold to.
// Throws Error{cancelled}.
Registration register_frame(const FeatureSet& features, const FeatureMaps& maps, const FrameMotion& guess,
                            const RegistrationSettings& settings, const Run& run);

}  // namespace bole::slam
