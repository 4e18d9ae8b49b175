// Bundle adjustment with depth: poses and points that fit the pixels and the measured depths best.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/run.h"
#include "base/transform.h"
#include "camera/camera_model.h"

namespace bole::rgbd {

inline constexpr double kernel_sigmas = 2;  // of Huber's loss in the adjustment

struct Observation {
  int view = 0, point = 0;
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  double size = 1;           // relative standard deviation of the pixel
  double inverse_depth = 0;  // 1 / m; 0: not measured
};

// A point whose place is known, as the corners of a board.
struct KnownPoint {
  int view = 0;
  Eigen::Vector3d point = Eigen::Vector3d::Zero();
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
};

struct Bundle {
  std::vector<const CameraModel*> cameras;  // of each view
  std::vector<Pose> T_world_camera;
  std::vector<char> placed;  // views without a pose take no part
  std::vector<Eigen::Vector3d> points;
  std::vector<Observation> observations;
  std::vector<KnownPoint> known;
  // measured depth = depth_scale * depth + depth_bias
  double depth_scale = 1, depth_bias = 0;
  double focal_factor = 1;  // of fx and fy of all cameras

  // Standard deviations, learnt from the residuals.
  double pixel_sigma = 0.7;
  double known_sigma = 0.3;            // pixels
  double inverse_depth_sigma = 0.004;  // 1 / m
};

struct BundleOptions {
  int fixed_view = -1;       // whose pose does not change; -1: none, known points hold the axes
  bool fixed_poses = false;  // only the points move
  bool free_depth = false;   // depth scale and bias are parameters
  bool free_focal = false;
  bool hold_scale = false;  // the distance of the farthest view from the fixed one stays: nothing else gives a scale
  bool learn_depth_sigma = true;
  int passes = 3;  // solutions, between which sigmas are learnt and outliers left out
};

struct BundleReport {
  bool converged = false;
  std::string message;
  int observations = 0, dropped = 0, iterations = 0;
};

// Changes everything that is not fixed; observations that do not fit are removed. Deterministic.
BundleReport adjust(Bundle& bundle, const BundleOptions& options, const Run& run);

// Errors of one observation with the present values.
struct ObservationError {
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  double inverse_depth = 0;  // 1 / m, measured less expected; 0 where none was measured
  bool behind = false;
};
ObservationError error_of(const Bundle& bundle, const Observation& observation);
ObservationError error_of(const Bundle& bundle, const KnownPoint& known);

}  // namespace bole::rgbd
