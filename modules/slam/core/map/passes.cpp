#include "slam/core/map/passes.h"

#include <algorithm>

namespace bole::slam {

std::vector<PathMark> mark_path(const Path& path, const std::vector<double>& keyframe_times_s, double spacing,
                                double radius) {
  auto marks = mark_places([&](double t) -> Eigen::Vector3d { return path.at(t).translation(); }, path.begin_s(),
                           path.end_s(), spacing, radius);
  if (!keyframe_times_s.empty())
    for (auto& m : marks) {
      const auto upper = std::ranges::upper_bound(keyframe_times_s, m.time_s);
      m.keyframe = static_cast<std::int32_t>(std::max<std::ptrdiff_t>(0, upper - keyframe_times_s.begin() - 1));
    }
  return marks;
}

}  // namespace bole::slam
