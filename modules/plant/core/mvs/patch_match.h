// Depth from colour alone: PatchMatch stereo of a picture with its neighbours (Bleyer et al. 2011; Galliani et al.
// 2015).
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "base/run.h"
#include "camera/camera_model.h"
#include "camera/image.h"

namespace bole::plant {

// A grey picture without distortion and where it was taken.
struct GreyView {
  CameraModel camera;  // no distortion
  Image<float> grey;   // 0 to 1
  Eigen::Isometry3f T_camera_local = Eigen::Isometry3f::Identity();
};

struct PatchMatchSetting {
  float min_depth = 0.1F, max_depth = 2;  // along z, metres
  int radius = 3;                         // of the patch, in pixels times step
  int step = 2;
  int iterations = 4;
  int best = 2;            // neighbours whose mean correlation counts
  float max_cost = 0.35F;  // 1 - correlation; worse pixels have no depth
  std::uint64_t seed = 1;
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // pixels to match
};

// Depth along z of the pixels of `reference`; 0 where no plane agrees with enough neighbours.
DepthImage match_patches(const GreyView& reference, const std::vector<const GreyView*>& neighbours,
                         const PatchMatchSetting& setting, const Run& run);

}  // namespace bole::plant
