// Level and height of the plot from control heights.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/report.h"
#include "survey/core/georeference/control_points.h"
#include "survey/core/georeference/height_fit.h"

namespace bole::survey {

struct ControlLevel {
  std::optional<HeightFit> heights;  // nothing without control heights
  double tilt_se_rad = 0;            // about each axis
  std::vector<std::string> notes;    // of each point; empty: nothing to say

  // A place in axes whose z is the height. Without a height of its own a place gets that of the centre.
  Eigen::Vector3d levelled(Eigen::Vector3d local) const;
};

// Heights that the others contradict are left out and named. The level of the map is an observation too, unless the
// heights contradict it. Throws Error{bad_input} for a residual beyond max_residual.
ControlLevel control_level(const std::vector<ControlPoint>& points, const GeoreferenceOptions& options, Report& report);

}  // namespace bole::survey
