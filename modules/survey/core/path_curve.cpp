#include "survey/core/path_curve.h"

#include <algorithm>

namespace bole::survey {

// Of poses that nearly coincide in time, as where recordings were merged, the first is kept: the velocity between them
// is only noise.
PathCurve::PathCurve(const Trajectory& trajectory, double max_gap_s) : max_gap_s_(max_gap_s) {
  const auto& poses = trajectory.poses;
  std::vector<double> steps;
  for (std::size_t i = 1; i < poses.size(); ++i) steps.push_back(poses[i].time_s - poses[i - 1].time_s);
  double apart_s = 0;
  if (!steps.empty()) {
    const auto usual = steps.begin() + static_cast<std::ptrdiff_t>(3 * steps.size() / 4);
    std::ranges::nth_element(steps, usual);
    constexpr double share = 0.05;
    apart_s = share * std::min(*usual, max_gap_s);
  }
  for (const auto& pose : poses)
    if (places_.empty() || pose.time_s - places_.back().time_s > apart_s)
      places_.push_back({pose.time_s, pose.T_target_sensor.translation()});
}

// Of the parabola through a pose and its neighbours; straight beside gaps.
Eigen::Vector3d PathCurve::velocity(std::size_t i) const {
  const auto slope = [&](std::size_t a) -> Eigen::Vector3d {
    return (places_[a + 1].at - places_[a].at) / (places_[a + 1].time_s - places_[a].time_s);
  };
  const auto connected = [&](std::size_t a) { return places_[a + 1].time_s - places_[a].time_s <= max_gap_s_; };
  const bool before = i > 0 && connected(i - 1), after = i + 1 < places_.size() && connected(i);
  if (!before && !after) return Eigen::Vector3d::Zero();
  if (!before) return slope(i);
  if (!after) return slope(i - 1);
  const double left = places_[i].time_s - places_[i - 1].time_s, right = places_[i + 1].time_s - places_[i].time_s;
  return (right * slope(i - 1) + left * slope(i)) / (left + right);
}

std::optional<Eigen::Vector3d> PathCurve::at(double time_s) const {
  if (!(time_s >= begin_s() && time_s <= end_s())) return std::nullopt;
  const auto upper = std::ranges::upper_bound(places_, time_s, {}, &Place::time_s);
  if (upper == places_.end()) return places_.back().at;
  const auto i = static_cast<std::size_t>(upper - places_.begin()) - 1;
  const double dt = places_[i + 1].time_s - places_[i].time_s;
  if (dt > max_gap_s_) return std::nullopt;
  const double u = (time_s - places_[i].time_s) / dt, v = 1 - u;
  const Eigen::Vector3d a = places_[i].at, b = places_[i + 1].at;
  return v * v * (1 + 2 * u) * a + u * u * (1 + 2 * v) * b + u * v * dt * (v * velocity(i) - u * velocity(i + 1));
}

Eigen::Vector3d PathCurve::nearest(double time_s) const {
  if (const auto place = at(time_s)) return *place;
  const auto upper = std::ranges::upper_bound(places_, time_s, {}, &Place::time_s);
  if (upper == places_.begin()) return upper->at;
  return (upper - 1)->at;
}

}  // namespace bole::survey
