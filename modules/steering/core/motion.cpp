#include "steering/core/motion.h"

#include <algorithm>
#include <cmath>

#include "base/no_number.h"

namespace bole::steering {

namespace {

constexpr double max_speed_m_s = 15;

}  // namespace

std::vector<std::int64_t> segments_between_gaps(const std::vector<double>& time_s,
                                                const std::vector<Eigen::Vector2d>& at, double max_gap_s) {
  std::vector<std::int64_t> segment(time_s.size(), 1);
  for (std::size_t i = 1; i < time_s.size(); ++i) {
    const double dt = time_s[i] - time_s[i - 1];
    segment[i] = segment[i - 1] + (dt > max_gap_s || (at[i] - at[i - 1]).norm() > max_speed_m_s * dt ? 1 : 0);
  }
  return segment;
}

std::vector<double> motion_yaws(const std::vector<Eigen::Vector2d>& at, const std::vector<std::int64_t>& segment,
                                double look_m, double min_m) {
  std::vector<double> yaw(at.size(), no_number);
  std::size_t back = 0, ahead = 0;
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (segment[back] != segment[i]) back = i;
    while (back + 1 < i && (at[i] - at[back + 1]).norm() >= look_m) ++back;
    ahead = std::max(ahead, i);
    while (ahead + 1 < at.size() && segment[ahead + 1] == segment[i] && (at[ahead] - at[i]).norm() < look_m) ++ahead;
    const Eigen::Vector2d d = at[ahead] - at[back];
    if (d.norm() > min_m) yaw[i] = std::atan2(d.y(), d.x());
  }
  return yaw;
}

}  // namespace bole::steering
