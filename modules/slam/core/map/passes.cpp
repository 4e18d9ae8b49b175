#include "slam/core/map/passes.h"

#include <algorithm>
#include <cmath>

namespace bole::slam {
namespace {

constexpr double scan_step_s = 0.05;  // the path is walked in steps of this much

bool comes_back(const std::vector<PathMark>& marks, std::size_t first_of_pass, double radius_m) {
  const auto& now = marks.back();
  for (std::size_t j = first_of_pass; j + 1 < marks.size(); ++j) {
    if (now.path_m - marks[j].path_m < 3 * radius_m) break;
    if ((now.place - marks[j].place).norm() < radius_m) return true;
  }
  return false;
}

}  // namespace

std::vector<PathMark> mark_path(const Path& path, const std::vector<double>& keyframe_times_s, double spacing_m,
                                double radius_m) {
  std::vector<PathMark> marks;
  std::size_t first_of_pass = 0;
  const auto steps = static_cast<std::size_t>(std::ceil((path.end_s() - path.begin_s()) / scan_step_s));
  Eigen::Vector3d last = path.at(path.begin_s()).translation();
  double path_m = 0;
  for (std::size_t i = 0; i <= steps; ++i) {
    const double t = std::min(path.begin_s() + static_cast<double>(i) * scan_step_s, path.end_s());
    const Eigen::Vector3d place = path.at(t).translation();
    path_m += (place - last).norm();
    last = place;
    if (!marks.empty() && path_m - marks.back().path_m < spacing_m) continue;
    const std::int32_t pass = marks.empty() ? 0 : marks.back().pass;
    marks.push_back({t, place, path_m, static_cast<std::int32_t>(marks.size()), pass});
    if (comes_back(marks, first_of_pass, radius_m)) {
      first_of_pass = marks.size() - 1;
      ++marks.back().pass;
    }
  }
  if (!keyframe_times_s.empty())
    for (auto& m : marks) {
      const auto upper = std::ranges::upper_bound(keyframe_times_s, m.time_s);
      m.keyframe = static_cast<std::int32_t>(std::max<std::ptrdiff_t>(0, upper - keyframe_times_s.begin() - 1));
    }
  return marks;
}

const PathMark& mark_at(const std::vector<PathMark>& marks, double time_s) {
  const auto upper = std::ranges::upper_bound(marks, time_s, {}, &PathMark::time_s);
  return upper == marks.begin() ? marks.front() : *(upper - 1);
}

}  // namespace bole::slam
