// Opens a ROS bag as a scan.
#pragma once

#include "io/core/bags/bag.h"
#include "io/core/scans/frame_source.h"

namespace bole::io {

std::shared_ptr<const FrameSource> open_bag_source(const std::filesystem::path& path, const FrameSourceOptions& options,
                                                   const Run& run, Report& report);
// Of a bag that is open already; `path` names it.
std::shared_ptr<const FrameSource> open_bag_source(const std::shared_ptr<const Bag>& bag,
                                                   const std::filesystem::path& path, const FrameSourceOptions& options,
                                                   const Run& run, Report& report);

}  // namespace bole::io
