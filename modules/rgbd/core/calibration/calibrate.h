// Calibration of a camera, and of the depth camera beside it, by pictures of a board.
#pragma once

#include <string>

#include "cloud/table.h"
#include "rgbd/core/calibration/depth_fit.h"
#include "rgbd/core/calibration/stereo_fit.h"

namespace bole::rgbd {

// One of `views` and `corners` is given. `infrared`: pictures that the depth camera took at the times of `views`.
struct CalibrationInput {
  const ViewSource* views = nullptr;
  const ViewSource* infrared = nullptr;
  const Table* corners = nullptr;
};

struct Calibration {
  RgbdCamera camera;
  std::optional<DepthFit> depth;
  Table parameters;  // name, value, sd, low, high, unit
  Table residuals;   // one row per view
  std::string camera_json;
  std::string residual_picture;  // SVG
  Report report;
};

// Throws Error{bad_input} where there is no board, too few views show it, or they leave the camera open.
Calibration calibrate(const CalibrationInput& input, const CalibrationOptions& options, const Run& run);

// Arrows from each corner to where it was seen, longer than they are by a factor that the picture names.
std::string residual_svg(const CameraFit& fit);

}  // namespace bole::rgbd
