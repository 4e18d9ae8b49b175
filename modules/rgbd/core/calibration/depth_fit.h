// The depth camera against the boards that the colour camera sees: where it is, and how its depth is off.
#pragma once

#include <array>
#include <vector>

#include "base/report.h"
#include "base/run.h"
#include "rgbd/core/calibration/zhang.h"

namespace bole::rgbd {

struct ViewDepth {
  std::size_t shot = 0;
  double distance = 0;  // of the board in the middle of its depth, metres
  double bias = 0;      // median of true less measured depth, metres
  std::size_t pixels = 0;
};

struct DepthFit {
  RgbdCamera camera;
  bool moved = false;                       // T_color_depth was fitted, else it is as given
  Vector6d sd_pose = Vector6d::Zero();      // rotation (rad), translation (m)
  int degree = -1;                          // of the polynomial; -1: there is none
  std::array<double, 3> bias{}, sd_bias{};  // true depth = z + b0 + b1 z + b2 z^2, metres
  double rms_before = 0, rms_after = 0;     // distance of depth points from the boards, metres
  std::vector<ViewDepth> views;

  double bias_at(double z) const { return bias[0] + z * (bias[1] + z * bias[2]); }
};

// Which of the unknowns are fitted.
struct DepthUnknowns {
  bool pose = true;  // of the depth camera; false: it is registered to colour, or known by stereo
  bool bias = true;
};

// Plane fits: points of the depth image inside the board must lie on it. The standard deviations count views, not
// pixels, because the pixels of one view are off together. Nothing where fewer than four views have depth on the board.
// What the views leave open stays as given, and is reported.
std::optional<DepthFit> fit_depth(const ViewSource& views, const std::vector<BoardShot>& shots, const CameraFit& color,
                                  const RgbdCamera& given, DepthUnknowns unknowns, const Run& run, Report& report);

}  // namespace bole::rgbd
