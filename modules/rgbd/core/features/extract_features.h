// Finds features in a colour image and reads their depth.
#pragma once

#include "cloud/core/view_source.h"
#include "rgbd/core/features/features.h"

namespace bole::rgbd {

struct FeatureOptions {
  FeatureKind kind = FeatureKind::sift;
  int max_features = 1500;  // in an image, spread over it
  int max_width = 1280;     // wider images are reduced to it
};

// Features of a view in a fixed order. `use_mask`: only where the mask shows the object. SIFT: Lowe 2004; ORB: Rublee
// et al. 2011 (both by OpenCV).
Features extract_features(const View& view, const RgbdCamera& camera, const FeatureOptions& options, bool use_mask);

}  // namespace bole::rgbd
