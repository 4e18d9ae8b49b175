// Adds views to those that have a pose, by the points that these see: for views without depth.
#pragma once

#include <optional>
#include <vector>

#include "base/run.h"
#include "rgbd/core/poses/pose_options.h"
#include "rgbd/core/poses/view_data.h"

namespace bole::rgbd {

struct GrownPoses {
  int added = 0;   // views
  int start = -1;  // the view whose axes are used, where no view had a pose: the scale is arbitrary then
};

// Where no view has a pose, two views with many matches and a wide angle begin. Then the views that see most of the
// known points follow (Snavely et al. 2006), with a bundle adjustment after each turn.
GrownPoses grow_poses(const std::vector<ViewData>& data, const std::vector<MatchedPair>& pairs, bool with_board,
                      const PoseOptions& options, std::vector<std::optional<Pose>>& poses, const Run& run);

}  // namespace bole::rgbd
