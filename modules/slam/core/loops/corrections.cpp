#include "slam/core/loops/corrections.h"

#include <algorithm>

namespace bole::slam {

Corrections::Corrections(const std::vector<double>& times_s, const std::vector<Pose>& T_map_before,
                         const std::vector<Pose>& T_map_after) {
  for (std::size_t k = 0; k < times_s.size(); ++k)
    corrections_.push_back({times_s[k], T_map_after[k] * T_map_before[k].inverse()});
}

Pose Corrections::at(double t) const {
  const auto upper = std::ranges::upper_bound(corrections_, t, {}, &StampedPose::time_s);
  if (upper == corrections_.begin()) return corrections_.front().T_target_sensor;
  if (upper == corrections_.end()) return corrections_.back().T_target_sensor;
  const auto &a = *(upper - 1), &b = *upper;
  return interpolate(a.T_target_sensor, b.T_target_sensor, (t - a.time_s) / (b.time_s - a.time_s));
}

}  // namespace bole::slam
