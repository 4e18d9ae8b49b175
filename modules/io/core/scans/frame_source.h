// Opens scans: recordings of a spinning LiDAR that are read frame by frame.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "base/option.h"
#include "base/report.h"
#include "base/run.h"
#include "cloud/scan_frame.h"

namespace bole::io {

struct FrameSourceOptions {
  std::string sensor = "auto";
  double min_range = 0.5;
  double max_range = 300;
  double cut_angle = 180;
  bool keep_partial_frames = false;
  int port = 0;
  double frame_period = 0.1;
  int rings = 64;
};
const OptionTable& option_table(const FrameSourceOptions*);

// A pcap file of Velodyne packets, a folder of KITTI .bin frames or a folder of .pcd frames; what it is, is seen from
// its content. `report` gets counts (packets, frames, lost and damaged ones) and warnings. Throws Error{bad_input} when
// nothing can be read from it.
std::shared_ptr<const FrameSource> open_frame_source(const std::filesystem::path& path,
                                                     const FrameSourceOptions& options, const Run& run, Report& report);
std::shared_ptr<const FrameSource> open_frame_source(const std::filesystem::path& path,
                                                     const FrameSourceOptions& options = {}, const Run& run = {});

// The locator of a scan opened with these options.
std::string frame_source_locator(const std::filesystem::path& path, const FrameSourceOptions& options);

}  // namespace bole::io
