// The walk divided into passes (cloud/core/path_passes.h), with the keyframes of the map.
#pragma once

#include <vector>

#include "cloud/core/path_passes.h"
#include "slam/core/map/path.h"

namespace bole::slam {

// `keyframe_times_s` are ascending; when empty, every mark counts as a keyframe.
std::vector<PathMark> mark_path(const Path& path, const std::vector<double>& keyframe_times_s, double spacing,
                                double radius);

}  // namespace bole::slam
