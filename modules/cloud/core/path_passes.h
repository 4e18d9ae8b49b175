// A path divided into passes: stretches within which no place is visited twice.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

namespace bole {
inline namespace cloud {

// Places along the path at an even spacing, with the keyframe and pass that apply from there on.
struct PathMark {
  double time_s = 0;
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  double travelled = 0;
  std::int32_t keyframe = 0;  // the number of the mark
  std::int32_t pass = 0;
};

// A new pass begins at a mark that is within `radius` of an earlier mark of the same pass although at least 3 radius
// were travelled between them: the walk has come back.
std::vector<PathMark> mark_places(const std::function<Eigen::Vector3d(double)>& place_at, double begin_s, double end_s,
                                  double spacing, double radius);

// The mark that applies at a time: the last one not after it. There must be one.
const PathMark& mark_at(const std::vector<PathMark>& marks, double time_s);

}  // namespace cloud
}  // namespace bole
