// The first pass over the frames: a path for the sensor, estimated or given.
#pragma once

#include <functional>
#include <vector>

#include "base/report.h"
#include "cloud/scan_frame.h"
#include "cloud/table.h"
#include "slam/core/map/path.h"
#include "slam/core/odometry/odometry.h"

namespace bole::slam {

// A path, and which frames may be mapped with it.
struct Track {
  struct Frame {
    std::size_t index = 0;  // in the source
    FrameMotion motion;     // used in place of the path where `own_motion` is set
  };
  Path path;
  std::vector<Frame> frames;
  bool own_motion = false;
  std::vector<std::pair<double, double>> gaps_s;  // stretches without a mapped frame
  std::vector<double> keyframe_times_s;
  Table frame_table;  // what the odometry found for each frame
  Table loop_table;   // revisits that were accepted
};

// Odometry, loops, pose graph and final adjustment as the options say; writes counts, metrics and warnings to `report`.
Track estimate_track(const FrameSource& source, const SlamOptions& resolved_options, Report& report, const Run& run);

// The path through given poses with the frames that it covers.
Track given_track(const FrameSource& source, const std::vector<StampedPose>& poses, Report& report, const Run& run);

}  // namespace bole::slam
