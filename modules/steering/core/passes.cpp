#include "steering/core/passes.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "steering/core/motion.h"

namespace bole::steering {
namespace {

constexpr double look_m = 1.0;          // way over which the direction of motion is taken
constexpr std::size_t min_samples = 5;  // fewer say nothing about a pass
constexpr double off_line_s = 1.0;      // so long the way may turn off without ending a pass

// Direction of motion at each sample.
std::vector<double> directions(const Track& track, const std::vector<std::int64_t>& segment) {
  return motion_yaws(track.truth, segment, look_m, 0.2 * look_m);
}

struct Stretch {
  std::size_t first, last;
};

// Runs of samples that `fits` accepts, with short breaks bridged; a gap ends them.
std::vector<Stretch> stretches(const Track& track, const std::vector<std::int64_t>& segment,
                               const std::function<bool(std::size_t)>& fits) {
  std::vector<Stretch> found;
  for (std::size_t i = 0; i < track.truth.size(); ++i) {
    if (!fits(i)) continue;
    if (!found.empty() && segment[found.back().last] == segment[i] &&
        (i == found.back().last + 1 || track.time_s[i] - track.time_s[found.back().last] <= off_line_s))
      found.back().last = i;
    else
      found.push_back({i, i});
  }
  return found;
}

double angle_between(double a, double b) { return std::abs(std::remainder(a - b, 2 * std::numbers::pi)); }

}  // namespace

std::vector<Pass> find_passes(const Track& track, const GuidanceLine& line, const PassLimits& limits) {
  const auto segment = segments_between_gaps(track.time_s, track.truth, limits.max_gap_s);
  const auto yaw = directions(track, segment);
  std::vector<Pass> passes;
  for (const int direction : {1, -1}) {
    const double wanted = line.yaw_rad + (direction > 0 ? 0 : std::numbers::pi);
    for (const auto& s : stretches(
             track, segment, [&](std::size_t i) { return angle_between(yaw[i], wanted) < limits.max_angle_rad; })) {
      Pass pass{s.first, s.last, 0, direction};
      const auto way = [&](std::size_t i) { return direction * line.along_m(track.truth[i]); };
      const double begin = way(s.first), end = way(s.last);
      while (pass.first < s.last && way(pass.first) - begin < limits.run_in_m) ++pass.first;
      while (pass.last > pass.first && end - way(pass.last) < limits.run_out_m) --pass.last;
      if (way(pass.last) - way(pass.first) < limits.min_length_m || pass.last - pass.first + 1 < min_samples) continue;
      double offset = 0;
      for (std::size_t i = pass.first; i <= pass.last; ++i) offset += line.offset_m(track.truth[i]);
      offset /= static_cast<double>(pass.last - pass.first + 1);
      pass.row = limits.row_width_m > 0 ? std::llround(offset / limits.row_width_m) : 0;
      passes.push_back(pass);
    }
  }
  std::sort(passes.begin(), passes.end(), [](const Pass& a, const Pass& b) { return a.first < b.first; });
  return passes;
}

std::optional<GuidanceLine> longest_straight(const Track& track, const PassLimits& limits) {
  const auto segment = segments_between_gaps(track.time_s, track.truth, limits.max_gap_s);
  const auto yaw = directions(track, segment);
  Stretch best{0, 0};
  double best_m = 0;
  for (std::size_t i = 0; i < track.truth.size();) {
    std::size_t j = i;
    while (j + 1 < track.truth.size() && segment[j + 1] == segment[j] &&
           angle_between(yaw[j + 1], yaw[i]) < limits.max_angle_rad)
      ++j;
    // The first of several of about the same length, for A is where the work began.
    if (const double m = (track.truth[j] - track.truth[i]).norm(); m > 1.05 * best_m && j - i + 1 >= min_samples) {
      best_m = m;
      best = {i, j};
    }
    i = j + 1;
  }
  if (best_m < limits.min_length_m) return std::nullopt;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  const double n = static_cast<double>(best.last - best.first + 1);
  for (std::size_t i = best.first; i <= best.last; ++i) mean += track.truth[i] / n;
  Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
  for (std::size_t i = best.first; i <= best.last; ++i) {
    const Eigen::Vector2d d = track.truth[i] - mean;
    scatter += d * d.transpose();
  }
  Eigen::Vector2d along = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(scatter).eigenvectors().col(1);
  if (along.dot(track.truth[best.last] - track.truth[best.first]) < 0) along = -along;
  return GuidanceLine{mean, std::atan2(along.y(), along.x())};
}

}  // namespace bole::steering
