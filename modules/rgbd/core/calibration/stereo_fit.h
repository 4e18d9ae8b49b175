// Depth camera to colour camera by pictures of one board that both take at the same times.
#pragma once

#include "rgbd/core/calibration/zhang.h"

namespace bole::rgbd {

struct StereoFit {
  Pose T_color_other = Pose::Identity();
  Vector6d sd = Vector6d::Zero();  // rotation (rad), translation (m): from the scatter between views
  double rms_px = 0;
  std::size_t views = 0;
  std::size_t left_out = 0;  // whose pose is far from the others'
};

// The cameras are known (fit_camera). Views belong together by their times, to half the least distance of times. Throws
// Error{bad_input} where fewer than four views are seen by both.
StereoFit fit_stereo(const ViewSource& color_views, const std::vector<BoardShot>& color_shots, const CameraFit& color,
                     const ViewSource& other_views, const std::vector<BoardShot>& other_shots, const CameraFit& other);

}  // namespace bole::rgbd
