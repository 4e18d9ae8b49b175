// Which way is up.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "base/run.h"
#include "cloud/point_cloud.h"
#include "survey/core/options.h"

namespace bole::survey {

struct Vertical {
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();  // in the axes of the cloud
  Level method = Level::none;                     // what was used in the end
  double standard_error_rad = 0;                  // of the direction, per axis; NaN when it cannot be told
  double scatter_rad = 0;                         // of single stems about it, per axis
  std::size_t stems = 0;
  std::vector<std::string> warnings;
};

// The cloud's z axis points up to within options.max_tilt_deg.
//   gravity: z, as the inertial unit told (fact level_sigma_deg of the cloud). Throws Error{bad_input} where it did
//   not. auto:    gravity where it is known to 0.3 deg, else stems. stems:  the robust mean (Tukey) of the stems' axes,
//   found again after levelling until it settles. Stems grow against
//           gravity on any slope, and single leaning ones are outvoted; a lean common to all of them is not seen.
//   ground: the robust plane through the lowest points of 1 m cells: right on level plots only.
Vertical find_vertical(const PointCloud& cloud, const FrameOptions& options, const Run& run);

}  // namespace bole::survey
