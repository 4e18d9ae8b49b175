// Ground and objects in a scan, from the order of its lines: Shan and Englot 2018 (LeGO-LOAM), section III-B.
#pragma once

#include <cstdint>
#include <vector>

#include "slam/core/odometry/scan.h"

namespace bole::slam {

enum class ScanLabel : std::uint8_t {
  loose,   // neither ground nor part of a large object: leaves, rain
  ground,  // the surface between two lines rises by less than 10 deg
  object   // at least 30 points that belong together, or 5 on at least 3 lines
};

// One label per point of the scan, in its order.
std::vector<ScanLabel> label_scan(const Scan& scan);

}  // namespace bole::slam
