// SLAM: takes frames, gives a trajectory and a dense map.
#pragma once

#include "base/report.h"
#include "base/run.h"
#include "cloud/point_cloud.h"
#include "cloud/scan_frame.h"
#include "cloud/table.h"
#include "cloud/trajectory.h"
#include "slam/core/options.h"

namespace bole::slam {

struct SlamResult {
  // Map axes: those of the sensor at the start of the first frame, or of the given trajectory.
  PointCloud points;
  Trajectory trajectory;  // the same axes, at an even rate, without the gaps of the recording
  // Per frame: time, overlap, residual, observability, sigma0, standard deviations of the pose, and the pose at its end
  // before loop closures and adjustment.
  Table odometry;
  Table loops;            // accepted loop closures: times, distance travelled, correction, overlap, how found
  Table loop_candidates;  // all that were tried: verdict, reason, residual, relative pose (loops/loop_tables.h)
  Table pose_graph;       // edges with information and residuals
  Report report;
};

// Reads the frames twice: for the trajectory (unless it is given) and for the map. Throws Error{bad_input} when no
// frame can be used, and Error{cancelled}. When the track is lost the map ends there, with a warning and
// Status::finished_early.
SlamResult run_slam(const FrameSource& source, const SlamOptions& options, const Run& run);

}  // namespace bole::slam
