// Calibration of a camera by planar boards (Zhang 2000, in OpenCV's form).
#pragma once

#include <array>
#include <vector>

#include "base/report.h"
#include "base/run.h"
#include "rgbd/core/calibration/board_shots.h"

namespace bole::rgbd {

struct CornerResidual {
  std::size_t shot = 0;
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  Eigen::Vector2d residual = Eigen::Vector2d::Zero();  // seen less projected, pixels
};

// Of one shot.
struct ShotFit {
  Pose T_camera_board = Pose::Identity();
  double rms_px = 0;
};

struct CameraFit {
  CameraModel camera;
  DistortionTerms terms = DistortionTerms::all;
  std::array<double, 9> sd{};  // of fx, fy, cx, cy (pixels) and k1, k2, p1, p2, k3; 0 where it was not fitted
  double rms_px = 0;
  double spread_rad = 0;       // greatest angle between two boards
  double coverage = 0;         // part of the image, in cells of a tenth, that a corner lies in
  std::vector<ShotFit> shots;  // one per shot; of those that took part
  std::vector<CornerResidual> residuals;
};

inline constexpr std::array<const char*, 9> intrinsic_names{"fx", "fy", "cx", "cy", "k1", "k2", "p1", "p2", "k3"};

// Shots that fit worse than the others are left out, one after the other, at most a third. Intervals are those of the
// least-squares fit: corners of a board that is not flat agree with one another, and widen nothing. Throws
// Error{bad_input} where fewer than four shots are left, where the boards are parallel, or where the focal length is
// not determined.
CameraFit fit_camera(std::vector<BoardShot>& shots, int width, int height, const CalibrationOptions& options,
                     const Run& run, Report& report);

}  // namespace bole::rgbd
