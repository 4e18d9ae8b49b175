// Opens scans: recordings of a spinning LiDAR that are read frame by frame.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "base/option.h"
#include "base/report.h"
#include "base/run.h"
#include "cloud/scan_frame.h"

namespace bole::io {

struct FrameSourceOptions {
  std::string sensor = "auto";
  std::string topic;  // of a bag; empty: the only one that holds a scan
  std::string imu;    // a topic of the bag, or a file; empty: the inertial unit that comes with the scan
  double min_range = 0.5;
  double max_range = 300;
  double cut_angle_deg = 180;  // clockwise from forward
  bool keep_partial_frames = false;
  bool laser_heights = true;
  std::optional<int> port;  // UDP; open: that of the first data packet
  double frame_period = 0.1;
  int rings = 64;
};
const OptionTable& option_table(const FrameSourceOptions*);

// Opens any format of the table in formats.h that holds a scan. `report` gets counts (packets, frames, lost and damaged
// ones) and warnings. Throws Error{bad_input} where nothing can be read.
std::shared_ptr<const FrameSource> open_frame_source(const std::filesystem::path& path,
                                                     const FrameSourceOptions& options, const Run& run, Report& report);
std::shared_ptr<const FrameSource> open_frame_source(const std::filesystem::path& path,
                                                     const FrameSourceOptions& options = {}, const Run& run = {});

// The locator of a scan opened with these options.
std::string frame_source_locator(const std::filesystem::path& path, const FrameSourceOptions& options);

}  // namespace bole::io
