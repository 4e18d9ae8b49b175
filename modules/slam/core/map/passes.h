// The walk cut into passes: stretches within which no place is visited twice.
#pragma once

#include <cstdint>
#include <vector>

#include "slam/core/map/path.h"

namespace bole::slam {

// Places along the path at an even spacing, with the key frame and pass that hold from there on.
struct PathMark {
  double time_s = 0;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  double path_m = 0;
  std::int32_t keyframe = 0;
  std::int32_t pass = 0;
};

// A new pass begins at a mark that is within `radius_m` of an earlier mark of the same pass although at least 3
// radius_m of way lie between them: the walk has come back. `keyframe_times_s` rise; when empty every mark counts as a
// key frame.
std::vector<PathMark> mark_path(const Path& path, const std::vector<double>& keyframe_times_s, double spacing_m,
                                double radius_m);

// The mark that holds at a time: the last one not after it.
const PathMark& mark_at(const std::vector<PathMark>& marks, double time_s);

}  // namespace bole::slam
