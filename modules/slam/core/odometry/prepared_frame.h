// A frame of the source, read and thinned, before it is registered.
#pragma once

#include <string>

#include "cloud/scan_frame.h"
#include "slam/core/odometry/features.h"
#include "slam/core/odometry/scan.h"

namespace bole::slam {

struct PreparedFrame {
  ScanFrame frame;
  Scan scan;
  Features features;
  std::string unreadable;  // why; empty where it could be read
  double read_s = 0, features_s = 0;
};

// Reads frame `i` into `out`, whose memory is used again. What makes it unreadable is kept, not thrown. Throws
// Error{cancelled}.
void prepare_frame(const FrameSource& source, std::size_t i, const ScanGate& gate, FeatureExtractor& extractor,
                   PreparedFrame& out);

}  // namespace bole::slam
