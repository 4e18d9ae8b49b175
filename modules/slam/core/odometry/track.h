// The first pass over the frames: a trajectory for the sensor, estimated or given.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "base/report.h"
#include "cloud/scan_frame.h"
#include "cloud/table.h"
#include "slam/core/map/path.h"
#include "slam/core/odometry/odometry.h"

namespace bole::slam {

// A path, and the frames that can be mapped with it.
struct Track {
  struct Frame {
    std::size_t index = 0;  // in the source
    FrameMotion motion;     // used instead of the path where `own_motion` is set
  };
  Path path;
  std::vector<Frame> frames;
  bool own_motion = false;
  std::vector<std::pair<double, double>> gaps_s;  // intervals without a mapped frame
  std::vector<double> keyframe_times_s;
  std::optional<double> level_sigma_rad;  // z of the path is up to this, by gravity; nothing where z is as it came
  Table frame_table;                      // results of the odometry for each frame
  Table loop_table;                       // accepted loop closures
  Table candidate_table;                  // all that were tried, see loop_tables.h
  Table graph_table;
};

// Runs odometry, loop closure, pose graph and final adjustment. Writes counts, metrics and warnings to `report`.
Track estimate_track(const FrameSource& source, const SlamSettings& settings, Report& report, const Run& run);

// The path through given poses, with the frames that it covers.
Track given_track(const FrameSource& source, const std::vector<StampedPose>& poses, Report& report, const Run& run);

}  // namespace bole::slam
