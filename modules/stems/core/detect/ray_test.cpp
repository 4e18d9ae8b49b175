#include "stems/core/detect/ray_test.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "cloud/core/whole/whole_size.h"

namespace bole::stems {
namespace {

constexpr double lowest_m = 0.6, highest_m = 2.4, beyond_m = 0.3;
constexpr double max_rays = 3e6;
constexpr double max_points = 1e8;  // of a whole that is not in parts: larger ones are never tested as one

// One of so many points is tested.
std::uint32_t stride_for(const PointCloud& points) {
  return static_cast<std::uint32_t>(std::min(points_of_whole(points), max_points) / max_rays) + 1;
}

// An even choice that does not depend on which other points there are.
bool is_chosen(const Eigen::Vector3f& p, std::uint32_t stride) {
  if (stride == 1) return true;
  std::uint64_t mix = 0;
  for (int k = 0; k < 3; ++k)
    mix = (mix ^ std::bit_cast<std::uint32_t>(p[k])) * 0x9e3779b97f4a7c15ULL, mix ^= mix >> 29;
  return (mix >> 20) % stride == 0;
}

double core_radius(const Stem& s) { return std::min(0.6 * s.radius, s.radius - 0.02); }

// Which stems stand in each square of the plot.
class StemSquares {
 public:
  explicit StemSquares(const std::vector<Stem>& stems) {
    Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const auto& s : stems)
      low = low.cwiseMin(s.breast_height.head<2>()), high = high.cwiseMax(s.breast_height.head<2>());
    corner_ = low.array() - 2;
    cell_ = std::max(1.0, (high - low).maxCoeff() / 2000);
    nx_ = static_cast<int>((high.x() + 2 - corner_.x()) / cell_) + 1,
    ny_ = static_cast<int>((high.y() + 2 - corner_.y()) / cell_) + 1;
    squares_.resize(static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_));
    lowest_z_ = std::numeric_limits<double>::infinity(), highest_z_ = -lowest_z_;
    for (const auto& s : stems)
      lowest_z_ = std::min(lowest_z_, s.ground_z + lowest_m), highest_z_ = std::max(highest_z_, s.ground_z + highest_m);
    for (std::uint32_t k = 0; k < stems.size(); ++k) {
      const auto& s = stems[k];
      const double rise = s.breast_height.z() - s.ground_z, along = std::max(rise, highest_m - rise);
      const double reach = s.radius + along * s.direction.head<2>().norm() / s.direction.z();
      discs_.push_back({s.breast_height.head<2>(), reach});
      for (int iy = clamp_y(s.breast_height.y() - reach); iy <= clamp_y(s.breast_height.y() + reach); ++iy)
        for (int ix = clamp_x(s.breast_height.x() - reach); ix <= clamp_x(s.breast_height.x() + reach); ++ix)
          square(ix, iy).push_back(k);
    }
  }

  // Calls f(stem) for stems along the ground track of the segment, where it passes at the height of some stem's core; a
  // stem may be met more than once in a row of squares.
  template <class F>
  void along(const Eigen::Vector3d& start, const Eigen::Vector3d& end, F&& f) const {
    const Eigen::Vector2d from = start.head<2>(), d = end.head<2>() - from;
    double t0 = 0, t1 = 1;
    const double rise = end.z() - start.z();
    if (const double beside = cell_ / std::max(1e-9, d.norm()); std::abs(rise) > 1e-9) {
      const double a = (lowest_z_ - start.z()) / rise, b = (highest_z_ - start.z()) / rise;
      t0 = std::max(t0, std::min(a, b) - beside), t1 = std::min(t1, std::max(a, b) + beside);
    } else if (start.z() < lowest_z_ || start.z() > highest_z_) {
      return;
    }
    for (int k = 0; k < 2; ++k) {  // clip to the squares
      const double low = corner_[k], high = corner_[k] + (k == 0 ? nx_ : ny_) * cell_;
      if (std::abs(d[k]) < 1e-12) {
        if (from[k] < low || from[k] > high) return;
        continue;
      }
      const double a = (low - from[k]) / d[k], b = (high - from[k]) / d[k];
      t0 = std::max(t0, std::min(a, b)), t1 = std::min(t1, std::max(a, b));
    }
    if (t0 >= t1) return;
    const int steps = static_cast<int>(d.norm() * (t1 - t0) / (0.5 * cell_)) + 1;
    const Eigen::Vector2d first = (from + t0 * d - corner_) / cell_, step = (t1 - t0) / (steps * cell_) * d;
    int last_x = -1, last_y = -1;
    for (int i = 0; i <= steps; ++i) {
      const int ix = static_cast<int>(std::clamp(first.x() + i * step.x(), 0.0, nx_ - 1.0)),
                iy = static_cast<int>(std::clamp(first.y() + i * step.y(), 0.0, ny_ - 1.0));
      if (ix == last_x && iy == last_y) continue;
      last_x = ix, last_y = iy;
      for (const auto k :
           squares_[static_cast<std::size_t>(iy) * static_cast<std::size_t>(nx_) + static_cast<std::size_t>(ix)])
        if (discs_[k].meets(from, d)) f(k);
    }
  }

 private:
  // The core of a stem lies within it, at all heights that are looked at.
  struct Disc {
    Eigen::Vector2d centre;
    double reach;
    bool meets(const Eigen::Vector2d& from, const Eigen::Vector2d& d) const {
      const Eigen::Vector2d to = centre - from;
      const double across = d.x() * to.y() - d.y() * to.x();
      return across * across <= reach * reach * d.squaredNorm();
    }
  };
  int clamp_x(double x) const { return static_cast<int>(std::clamp((x - corner_.x()) / cell_, 0.0, nx_ - 1.0)); }
  int clamp_y(double y) const { return static_cast<int>(std::clamp((y - corner_.y()) / cell_, 0.0, ny_ - 1.0)); }
  std::vector<std::uint32_t>& square(int ix, int iy) {
    return squares_[static_cast<std::size_t>(iy) * static_cast<std::size_t>(nx_) + static_cast<std::size_t>(ix)];
  }

  Eigen::Vector2d corner_;
  double cell_ = 1;
  double lowest_z_ = 0, highest_z_ = 0;  // of the cores of all stems
  int nx_ = 0, ny_ = 0;
  std::vector<Disc> discs_;
  std::vector<std::vector<std::uint32_t>> squares_;
};

enum class Meeting { none, through, stopped };

Meeting meet(const Stem& s, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const double core = core_radius(s);
  // Nearest approach of the ray to the axis line.
  const Eigen::Vector3d d = to - from, w = from - s.breast_height;
  const double da = d.dot(s.direction);
  const Eigen::Vector3d d_across = d - da * s.direction, w_across = w - w.dot(s.direction) * s.direction;
  const double length2 = d_across.squaredNorm();
  if (length2 < 1e-6) return Meeting::none;
  const double t = -w_across.dot(d_across) / length2, length = std::sqrt(length2);
  if (t <= 0 || (w_across + t * d_across).norm() > core) return Meeting::none;
  const double height = (from + t * d).z() - s.ground_z;
  if (height < lowest_m || height > highest_m) return Meeting::none;
  const double past = (1 - t) * length;  // how far beyond the axis the ray ends, across it
  if (past > s.radius + beyond_m) return Meeting::through;
  return past > -s.radius - 0.10 ? Meeting::stopped : Meeting::none;
}

}  // namespace

std::vector<RayCount> count_rays(const std::vector<Stem>& stems, const PointCloud& points, const SensorOf& sensor_of,
                                 const Run& run) {
  std::vector<RayCount> none(stems.size());
  if (stems.empty()) return none;
  const StemSquares squares(stems);
  const std::uint32_t stride = stride_for(points);
  auto counts = tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, points.size(), 1 << 14), none,
      [&](const tbb::blocked_range<std::size_t>& block, std::vector<RayCount> sum) {
        if (run.cancelled()) return sum;
        std::vector<std::uint32_t> met;
        for (auto i = block.begin(); i != block.end(); ++i) {
          const auto& p = points.positions()[i];
          if (!is_chosen(p, stride)) continue;
          const auto sensor = sensor_of(i);
          if (!sensor || !p.allFinite() || !sensor->allFinite()) continue;
          const Eigen::Vector3d from = sensor->cast<double>(), to = p.cast<double>();
          met.clear();
          // One step further, so that a ray stopped at the near side meets the stem's square.
          const Eigen::Vector3d d = to - from;
          const double beyond = 0.5 / std::max(1e-9, d.head<2>().norm());
          squares.along(from, to + std::min(beyond, 1.0) * d, [&](std::uint32_t k) {
            if (std::ranges::find(met, k) != met.end()) return;
            met.push_back(k);
            const auto meeting = meet(stems[k], from, to);
            if (meeting == Meeting::through) ++sum[k].through;
            if (meeting == Meeting::stopped) ++sum[k].stopped;
          });
        }
        return sum;
      },
      [](std::vector<RayCount> a, const std::vector<RayCount>& b) {
        for (std::size_t k = 0; k < a.size(); ++k) a[k].through += b[k].through, a[k].stopped += b[k].stopped;
        return a;
      });
  run.check_cancel();
  return counts;
}

double share_through(const RayCount& count) {
  constexpr std::int64_t enough = 20;
  const auto all = count.through + count.stopped;
  return all < enough ? std::numeric_limits<double>::quiet_NaN()
                      : static_cast<double>(count.through) / static_cast<double>(all);
}

}  // namespace bole::stems
