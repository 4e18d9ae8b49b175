// Registers a frame against a map: robust point-to-plane and point-to-line least squares over a rigid motion of the
// frame, or over its begin and end pose.
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
  explicit FeatureMaps(double cell_size) : edges(cell_size), planes(cell_size) {}
  DistributionMap edges, planes;
  void clear() {
    edges.clear();
    planes.clear();
  }
};

// What a point is matched to: the normal distance to a plane, or the distance to a line.
struct Target {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  // normal of the plane, direction of the line
  double variance = 1;                              // thickness of the surface and range noise
  double leverage = 0;  // share of the scatter of the surface points that moves it at this place, 0 to 1
  enum class Kind : std::uint8_t { none, plane, line } kind = Kind::none;
};

// The surface at the place that is planar (or linear) enough, on the finest level from `first_level` to below
// `end_level` that has one made of at least `min_lines` scan lines.
std::optional<LocalSurface> find_surface(const DistributionMap& map, const HalfCell& place, bool line, int first_level,
                                         int min_lines = 0, int end_level = DistributionMap::levels);
// Whether a point can be matched to it.
bool is_distinct(const LocalSurface& surface, bool line);

// The surface that a point met where it was looked for last. As long as the map stays as it is, places in the same half
// cell meet the same one: a registration that settles asks for few of them again.
class MetSurface {
 public:
  // As find_surface().
  const std::optional<LocalSurface>& find(const DistributionMap& map, const HalfCell& place, bool line, int first_level,
                                          int min_lines = 0);

  // Whether that takes no search.
  bool knows(const HalfCell& place, int first_level) const { return place == place_ && first_level == first_level_; }

 private:
  HalfCell place_ = HalfCell::Zero();
  int first_level_ = DistributionMap::levels;  // no level was looked at
  int min_lines_ = 0;
  std::optional<LocalSurface> surface_;
};
Target as_target(const LocalSurface& surface, bool line, double sigma);
// Both of these; Kind::none where there is no surface.
Target find_target(const DistributionMap& map, const Eigen::Vector3d& point_in_map, bool line, int first_level,
                   double sigma);

// Normal equations of one pose. The unknowns are a small turn about the sensor (rad, map axes) and a shift of it (m),
// and d(point)/d(turn) = -[lever]x with `lever` the point minus the position of the sensor.
struct PoseEquations {
  Matrix6d H = Matrix6d::Zero();
  Vector6d g = Vector6d::Zero();
  double squared_error = 0;  // squared distance to the target
  double weight = 0;         // 1 / m2, kernel included
  bool inlier = false;       // within the kernel
};
// Weighted by the variance of the target and the Geman-McClure kernel of `kernel` standard deviations.
PoseEquations pose_equations(const Target& target, const Eigen::Vector3d& point_in_map, const Eigen::Vector3d& lever,
                             double kernel);
// As SPEC A7 has them: Newton's iteration on the squares of the distances, each with the given weight (1 / m2) and
// without a robust kernel. Beyond `kernel` standard deviations of the target the match does not count.
PoseEquations condition_equations(const Target& target, const Eigen::Vector3d& point_in_map,
                                  const Eigen::Vector3d& lever, double kernel, double weight);

using Matrix12d = Eigen::Matrix<double, 12, 12>;

class PointMatches;

enum class MotionModel {
  rigid,   // the motion within the frame is kept and the frame is moved as a whole: 6 unknowns
  end,     // the begin pose is fixed, the end pose is estimated without priors: 6 unknowns
  elastic  // begin and end pose, with priors of continuity and smoothness: 12 unknowns; 18 with a bend between them
};

// Standard deviations of how far the middle of a frame departs from a straight motion between begin and end.
struct BendPrior {
  double sigma = 0.02, sigma_rad = 0.01;
};

struct RegistrationSettings {
  MotionModel model = MotionModel::rigid;
  int iterations = 12;
  int coarse_iterations = 2;  // of these, iterations that start on coarser levels and with a wider kernel
  double sigma = 0.02;
  double kernel_sigmas = 3;
  // Planes give height, roll and pitch, lines the rest (rigid only): Shan and Englot 2018.
  bool two_step = false;
  std::optional<AdjustmentPriors> priors;  // instead of `sigma`
  // See condition_equations(). `equal`: every match has the weight 1 / sigma^2 (A = I).
  bool plain = false, equal = false;
  // Single points to match against, instead of the surfaces of the maps.
  const PointMatches* points = nullptr;
  // Elastic only: standard deviations of the begin from the prediction, and of the motion over the frame from it.
  double begin_sigma = 0.004, begin_sigma_rad = 0.001;
  double motion_sigma = 0.05, motion_sigma_rad = 0.02;
  // Elastic only: covariance (turn rad, shift m; map axes) of the predicted begin, beside begin_sigma.
  Matrix6d begin_covariance = Matrix6d::Zero();
  // Elastic only: the motion is a parabola in time that departs from the straight one by the bend in the middle.
  std::optional<BendPrior> bend;
  // Elastic only, instead of these: information about begin and end (turn, shift of each; map axes) from the guess.
  std::optional<Matrix12d> joint_information;
  // Keeps what the points tell about motions that they determine: turn and shift of the sensor are projected by it.
  std::optional<Matrix6d> determined;
  double converged_shift = 5e-4, converged_turn_rad = 5e-5;
};

struct Registration {
  FrameMotion motion;
  int iterations = 0;
  bool converged = false;  // the last step was below both limits; else the iterations ran out
  std::size_t tried = 0, matched = 0, inliers = 0;
  double overlap = 0;                       // inliers / tried
  double rms = 0;                           // of the inliers, along their normals
  Matrix6d information = Matrix6d::Zero();  // of the end pose (turn, shift), data only
  double conditioning = 0;                  // smallest over largest eigenvalue of the shift part, turn eliminated
  // Standard deviation of unit weight, 1 when the weights are right, and sigma0^2 information^-1 (turn rad, shift m;
  // map axes).
  double sigma0 = 0;
  Matrix6d covariance = Matrix6d::Zero();
  Matrix12d begin_end_information = Matrix12d::Zero();  // elastic: of both poses, data only
  // Of an elastic frame with a bend: of its end, begin and bend unknown too, priors included (turn rad, shift m; map
  // axes). The points of a frame tell its middle to a millimetre or two, and its end to centimetres.
  Matrix6d end_covariance = Matrix6d::Zero();
  // What the points met, edges first; empty with RegistrationSettings::points.
  std::vector<MetSurface> met;
};

// `guess` is where the search starts, and for MotionModel::elastic also the prediction of the priors. Throws
// Error{cancelled}.
// `maps` are not used with RegistrationSettings::points.
Registration register_frame(const FeatureSet& features, const FeatureMaps& maps, const FrameMotion& guess,
                            const RegistrationSettings& settings, const Run& run);

}  // namespace bole::slam
