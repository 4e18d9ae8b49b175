// One stem along its height: its points from the side and the stem curve.
#pragma once

#include <limits>

#include "render/draw/axes.h"
#include "render/draw/cloud_key.h"
#include "render/draw/figure.h"

namespace bole::render {

struct ProfileSection {
  double height_m = 0, offset_m = 0, diameter_m = 0;
  bool used = false;
};

struct StemProfileData {
  std::vector<Eigen::Vector2d> points;   // offset from the axis at breast height across the view, height above ground
  std::vector<CloudDots> beside;         // other clouds, likewise, in their colours
  std::vector<ProfileSection> sections;  // by height
  double breast_height_m = 1.3;
  double dbh_m = std::numeric_limits<double>::quiet_NaN();
  double slice_m = 1.3;  // where the slice view cuts
  double reach_m = 0.5, top_m = 8;
};

Frame profile_frame(const StemProfileData& data, double width_mm, double height_mm);
Figure stem_profile(const StemProfileData& data, double width_mm, double height_mm);

}  // namespace bole::render
