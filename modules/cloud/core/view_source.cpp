#include "cloud/core/view_source.h"

#include <algorithm>
#include <cmath>

namespace bole {
inline namespace cloud {

std::optional<Pose> pose_of_view(const Trajectory& poses, double time_s) {
  constexpr double same_time_s = 1e-6;
  const auto it = std::ranges::lower_bound(poses.poses, time_s - same_time_s, {}, &StampedPose::time_s);
  if (it == poses.poses.end() || std::abs(it->time_s - time_s) > same_time_s) return std::nullopt;
  return it->T_target_sensor;
}

}  // namespace cloud
}  // namespace bole
