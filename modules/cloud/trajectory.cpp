#include "cloud/trajectory.h"

#include <algorithm>
#include <cmath>

#include "base/option.h"

namespace bole {
inline namespace cloud {

Pose Trajectory::at(double time_s, double max_extrapolation_s) const {
  if (poses.size() < 2) throw bad_input("the trajectory has " + std::to_string(poses.size()) + " poses", "at least 2");
  if (!(time_s >= poses.front().time_s - max_extrapolation_s && time_s <= poses.back().time_s + max_extrapolation_s))
    throw bad_input(
        "no pose near time " + number_text(time_s) + " s",
        "a time from " + number_text(poses.front().time_s) + " to " + number_text(poses.back().time_s) + " s",
        "Check that the trajectory and the scan use the same clock");
  auto upper = std::ranges::upper_bound(poses, time_s, {}, &StampedPose::time_s);
  upper = std::clamp(upper, poses.begin() + 1, poses.end() - 1);
  const auto& a = *(upper - 1);
  const auto& b = *upper;
  return interpolate(a.T_target_sensor, b.T_target_sensor, (time_s - a.time_s) / (b.time_s - a.time_s));
}

double Trajectory::length_m() const {
  double sum = 0;
  for (std::size_t i = 1; i < poses.size(); ++i)
    sum += (poses[i].T_target_sensor.translation() - poses[i - 1].T_target_sensor.translation()).norm();
  return sum;
}

}  // namespace cloud
}  // namespace bole
