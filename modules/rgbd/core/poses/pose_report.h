// What the stage hands out: poses, tables, the sparse cloud, counts and findings.
#pragma once

#include <optional>
#include <vector>

#include "rgbd/core/poses/estimate_poses.h"
#include "rgbd/core/poses/pose_tables.h"

namespace bole::rgbd {

struct PoseOutcome {
  const ViewSource& views;
  const std::vector<ViewData>& data;
  const ViewMatcher& matcher;
  const std::vector<std::optional<Pose>>& poses;
  const std::vector<TrackingState>& states;
  const MadeBundle& made;
  std::vector<PoseSigma> sigmas;  // empty: not known
  bool given = false;
  int contradicted = 0;  // pairs
};

// Fills everything but what the report has already; the facts world_axes and scale_source must be there.
void tell_poses(const PoseOutcome& outcome, EstimatedPoses& out);

}  // namespace bole::rgbd
