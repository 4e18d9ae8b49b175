#include "cloud/core/path_passes.h"

#include <algorithm>
#include <cmath>

namespace bole {
inline namespace cloud {
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

std::vector<PathMark> mark_places(const std::function<Eigen::Vector3d(double)>& place_at, double begin_s, double end_s,
                                  double spacing, double radius) {
  std::vector<PathMark> marks;
  std::size_t first_of_pass = 0;
  const auto steps = static_cast<std::size_t>(std::ceil((end_s - begin_s) / scan_step_s));
  Eigen::Vector3d last = place_at(begin_s);
  double travelled = 0;
  for (std::size_t i = 0; i <= steps; ++i) {
    const double t = std::min(begin_s + static_cast<double>(i) * scan_step_s, end_s);
    const Eigen::Vector3d place = place_at(t);
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
  return marks;
}

const PathMark& mark_at(const std::vector<PathMark>& marks, double time_s) {
  const auto upper = std::ranges::upper_bound(marks, time_s, {}, &PathMark::time_s);
  return upper == marks.begin() ? marks.front() : *(upper - 1);
}

}  // namespace cloud
}  // namespace bole
