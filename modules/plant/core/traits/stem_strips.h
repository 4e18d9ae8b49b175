// Edges of the stem in the pictures.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/report.h"
#include "base/run.h"
#include "cloud/core/view_source.h"
#include "plant/core/separate/point_grid.h"
#include "plant/core/traits/stem_curve.h"

namespace bole::plant {

// A measurement across the stem in one view. Rays and the camera's place are in plant axes.
struct StemStrip {
  std::uint32_t view = 0;
  double z = 0;                                 // height on the axis
  Eigen::Vector2d left, right;                  // pixels
  double sd_left = 0, sd_right = 0, sigma = 0;  // pixels
  double contrast = 0, residual = 0;            // of 0..1
  Eigen::Vector3d centre;                       // of the camera
  Eigen::Vector3d ray_left, ray_right;          // unit
  double pixels_per_unit = 0;                   // at the stem
  double weight = 1;                            // by the joint fit
};

struct StripSearch {
  StemCurve axis;
  double radius = 0;           // what the cloud says, or a guess
  double radius_share = 2;     // widths from 1 / share to share of it are tried
  double shift = 0;            // the axis may be off by so much
  double bottom = 0, top = 0;  // z of the stretch
  int sections = 24;
  bool linear_light = true;  // sRGB undone: optics blur light, not codes
  double usual_spread = 0;   // point spread of sharp views, pixels; 0: not known, each view finds its own
};

struct ViewUse {
  std::uint32_t view = 0;
  std::size_t tried = 0, occluded = 0, measured = 0;
  double sigma = 0;      // point spread that was taken, pixels
  double own_sigma = 0;  // that its strips alone would have
  double contrast = 0;   // median of its strips, 0..1
  double cost = 0;       // mean square error of the fitted strips in codes of the picture (0..1)
  std::string state;     // used, no_pose, outside, hidden, no_contrast, unreadable
};

struct StripsFound {
  std::vector<StemStrip> strips;
  std::vector<ViewUse> views;
};

// The point spread that the views of most contrast agree on; 0 where fewer than five views have measured it.
double usual_spread(const std::vector<ViewUse>& views);

// `cloud`: everything around, in plant axes, for what hides the stem; `spacing`: of its points.
// `T_plant_world`: from the axes of the poses. Views that cannot be read are listed, not fatal.
StripsFound find_strips(const ViewSource& views, const Trajectory& poses, const Pose& T_plant_world,
                        const Points3& cloud, double spacing, const StripSearch& search,
                        const std::vector<std::uint32_t>& which, const Run& run);
// The same for several stretches of a stem at once: every picture is read once.
std::vector<StripsFound> find_strips(const ViewSource& views, const Trajectory& poses, const Pose& T_plant_world,
                                     const Points3& cloud, double spacing, std::span<const StripSearch> searches,
                                     const std::vector<std::uint32_t>& which, const Run& run);

}  // namespace bole::plant
