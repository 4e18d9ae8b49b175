// The walk divided into passes: stretches within which no place is visited twice.
#pragma once

#include <cstdint>
#include <vector>

#include "slam/core/map/path.h"

namespace bole::slam {

// Places along the path at an even spacing, with the keyframe and pass that apply from there on.
struct PathMark {
  double time_s = 0;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  double travelled = 0;
  std::int32_t keyframe = 0;
  std::int32_t pass = 0;
};

// A new pass begins at a mark that is within `radius` of an earlier mark of the same pass although at least 3 radius
// were travelled between them: the walk has come back. `keyframe_times_s` are ascending; when empty, every mark counts
// as a keyframe.
std::vector<PathMark> mark_path(const Path& path, const std::vector<double>& keyframe_times_s, double spacing,
                                double radius);

// The mark that applies at a time: the last one not after it.
const PathMark& mark_at(const std::vector<PathMark>& marks, double time_s);

}  // namespace bole::slam
