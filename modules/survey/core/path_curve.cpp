#include "survey/core/path_curve.h"

#include <algorithm>

namespace bole::survey {

// Of the parabola through a pose and its neighbours; straight beside gaps.
Eigen::Vector3d PathCurve::velocity(std::size_t i) const {
  const auto slope = [&](std::size_t a) -> Eigen::Vector3d {
    return (poses_[a + 1].T_target_sensor.translation() - poses_[a].T_target_sensor.translation()) /
           (poses_[a + 1].time_s - poses_[a].time_s);
  };
  const auto connected = [&](std::size_t a) { return poses_[a + 1].time_s - poses_[a].time_s <= max_gap_s_; };
  const bool before = i > 0 && connected(i - 1), after = i + 1 < poses_.size() && connected(i);
  if (!before && !after) return Eigen::Vector3d::Zero();
  if (!before) return slope(i);
  if (!after) return slope(i - 1);
  const double left = poses_[i].time_s - poses_[i - 1].time_s, right = poses_[i + 1].time_s - poses_[i].time_s;
  return (right * slope(i - 1) + left * slope(i)) / (left + right);
}

std::optional<Eigen::Vector3d> PathCurve::at(double time_s) const {
  if (!(time_s >= begin_s() && time_s <= end_s())) return std::nullopt;
  const auto upper = std::ranges::upper_bound(poses_, time_s, {}, &StampedPose::time_s);
  if (upper == poses_.end()) return poses_.back().T_target_sensor.translation();
  const auto i = static_cast<std::size_t>(upper - poses_.begin()) - 1;
  const double dt = poses_[i + 1].time_s - poses_[i].time_s;
  if (dt > max_gap_s_) return std::nullopt;
  const double u = (time_s - poses_[i].time_s) / dt, v = 1 - u;
  const Eigen::Vector3d a = poses_[i].T_target_sensor.translation(), b = poses_[i + 1].T_target_sensor.translation();
  return v * v * (1 + 2 * u) * a + u * u * (1 + 2 * v) * b + u * v * dt * (v * velocity(i) - u * velocity(i + 1));
}

Eigen::Vector3d PathCurve::nearest(double time_s) const {
  if (const auto place = at(time_s)) return *place;
  const auto upper = std::ranges::upper_bound(poses_, time_s, {}, &StampedPose::time_s);
  if (upper == poses_.begin()) return upper->T_target_sensor.translation();
  return (upper - 1)->T_target_sensor.translation();
}

}  // namespace bole::survey
