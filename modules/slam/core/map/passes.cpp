#include "slam/core/map/passes.h"

#include <algorithm>
#include <cmath>

namespace bole::slam {
namespace {

constexpr double scan_step_s = 0.05;  // step along the path

bool comes_back(const std::vector<PathMark>& marks, std::size_t first_of_pass, double radius) {
  const auto& now = marks.back();
  for (std::size_t j = first_of_pass; j + 1 < marks.size(); ++j) {
    if (now.travelled - marks[j].travelled < 3 * radius) break;
    if ((now.place - marks[j].place).norm() < radius) return true;
  }
  return false;
}

}  // namespace

std::vector<PathMark> mark_path(const Path& path, const std::vector<double>& keyframe_times_s, double spacing,
                                double radius) {
  std::vector<PathMark> marks;
  std::size_t first_of_pass = 0;
  const auto steps = static_cast<std::size_t>(std::ceil((path.end_s() - path.begin_s()) / scan_step_s));
  Eigen::Vector3d last = path.at(path.begin_s()).translation();
  double travelled = 0;
  for (std::size_t i = 0; i <= steps; ++i) {
    const double t = std::min(path.begin_s() + static_cast<double>(i) * scan_step_s, path.end_s());
    const Eigen::Vector3d place = path.at(t).translation();
    travelled += (place - last).norm();
    last = place;
    if (!marks.empty() && travelled - marks.back().travelled < spacing) continue;
    const std::int32_t pass = marks.empty() ? 0 : marks.back().pass;
    marks.push_back({t, place, travelled, static_cast<std::int32_t>(marks.size()), pass});
    if (comes_back(marks, first_of_pass, radius)) {
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
