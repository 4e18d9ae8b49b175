// Camera poses by RGB-D SLAM: features, screened matches, a board where there is one, and bundle adjustment with depth.
#pragma once

#include "base/report.h"
#include "base/run.h"
#include "cloud/core/view_source.h"
#include "cloud/point_cloud.h"
#include "cloud/table.h"
#include "rgbd/core/poses/pose_options.h"

namespace bole::rgbd {

struct EstimatedPoses {
  Trajectory poses;   // T_world_camera of the colour camera; views that were lost are missing
  PointCloud points;  // of the bundle adjustment, with colours; world axes
  Table tracking;     // one row per view
  Table matches;      // of a few pairs: pixels, and what became of each match
  Report report;
};

// `given`: poses at the times of the views, for source=given; null: those of the views. Throws Error{bad_input} where
// the views cannot be used: none, no feature in any, no two that show the same thing, no depth and no board.
EstimatedPoses estimate_poses(const ViewSource& views, const Trajectory* given, const PoseOptions& options,
                              const Run& run);

}  // namespace bole::rgbd
