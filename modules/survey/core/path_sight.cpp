#include "survey/core/path_sight.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace bole::survey {
namespace {

constexpr double half_width_m = 25, below_m = 3, above_m = 5, voxel_m = 0.1;
constexpr double longest_ray_m = 22, shortest_ray_m = 2;
constexpr std::size_t rays_per_window = 1500, min_rays = 300, max_points = 2'000'000;

struct Ray {
  Eigen::Vector3d sensor, point;
};

// The points about one place of the path as voxels.
class Window {
 public:
  explicit Window(const Eigen::Vector3d& middle) : low_(middle - Eigen::Vector3d(half_width_m, half_width_m, below_m)) {
    const Eigen::Vector3d size(2 * half_width_m, 2 * half_width_m, below_m + above_m);
    for (int k = 0; k < 3; ++k) cells_[k] = static_cast<int>(std::ceil(size[k] / voxel_m));
    counts_.assign(static_cast<std::size_t>(cells_.prod()), 0);
  }

  bool add(const Eigen::Vector3d& p) {
    const auto at = cell(p);
    if (!at) return false;
    if (counts_[*at] < 255) ++counts_[*at];
    return true;
  }

  // Stems and the ground are seen by more points than leaves and noise.
  void settle() {
    std::array<std::size_t, 256> histogram{};
    for (const auto c : counts_) ++histogram[c];
    std::size_t filled = 0, sum = 0;
    for (std::size_t c = 1; c < 256; ++c) filled += histogram[c];
    std::size_t median = 1;
    while (median < 255 && (sum += histogram[median]) * 2 < filled) ++median;
    solid_ = static_cast<std::uint8_t>(std::max<std::size_t>(2, median));
  }

  // Whether the way between the ends is barred. Near the point stands the surface that it is on, seen at a slant.
  bool barred(const Ray& ray, const Eigen::Vector2d& shift) const {
    const Eigen::Vector3d from = ray.sensor + Eigen::Vector3d(shift.x(), shift.y(), 0), way = ray.point - from;
    const double length = way.norm();
    constexpr double near_sensor_m = 0.5, near_point_m = 0.4, slant = 0.08;
    const double end = length - near_point_m - slant * length;
    const Eigen::Vector3d step = way / length;
    for (double s = near_sensor_m; s < end; s += voxel_m) {
      const auto at = cell(from + s * step);
      if (at && counts_[*at] >= solid_) return true;
    }
    return false;
  }

 private:
  std::optional<std::size_t> cell(const Eigen::Vector3d& p) const {
    const Eigen::Array3d place = ((p - low_) / voxel_m).array().floor();
    if (!(place >= 0).all() || !(place < cells_.cast<double>()).all()) return {};
    const Eigen::Array3i at = place.cast<int>();
    return static_cast<std::size_t>((at[2] * cells_[1] + at[1]) * cells_[0] + at[0]);
  }

  Eigen::Vector3d low_;
  Eigen::Array3i cells_ = Eigen::Array3i::Zero();
  std::vector<std::uint8_t> counts_;
  std::uint8_t solid_ = 2;
};

bool can_be_judged(const Ray& ray, const Eigen::Vector3d& middle) {
  constexpr double lower_m = 0.6, higher_m = 2, room_m = 5;  // room for the shifts
  const double up = ray.point.z() - ray.sensor.z(), range = (ray.point - ray.sensor).norm();
  return up > -lower_m && up < higher_m && range > shortest_ray_m && range < longest_ray_m &&
         (ray.sensor - middle).head<2>().cwiseAbs().maxCoeff() < half_width_m - room_m;
}

std::vector<Eigen::Vector2d> shifts_to_try() {
  std::vector<Eigen::Vector2d> shifts{Eigen::Vector2d::Zero()};
  for (const double length : {1.0, 2.0, 4.0})
    for (int k = 0; k < 8; ++k) {
      const double a = k * std::numbers::pi / 4;
      shifts.emplace_back(length * std::cos(a), length * std::sin(a));
    }
  return shifts;
}

// Adds the barred rays of one window for each shift, and their number.
std::size_t look_from(const Eigen::Vector3d& middle, const PointCloud& points, const PathCurve& curve, double offset_s,
                      const std::vector<Eigen::Vector2d>& shifts, std::vector<std::size_t>& barred) {
  const auto& time = points.values<double>(arrays::time);
  Window window(middle);
  std::vector<Ray> rays;
  const std::size_t step = 1 + points.size() / (5 * max_points);
  for (std::size_t i = 0; i < points.size(); i += step) {
    const auto p = points.position(i);
    if (!window.add(p) || !std::isfinite(time[i])) continue;
    const auto sensor = curve.at(time[i] - offset_s);
    if (sensor && can_be_judged({*sensor, p}, middle)) rays.push_back({*sensor, p});
  }
  window.settle();
  const std::size_t every = 1 + rays.size() / rays_per_window;
  std::size_t used = 0;
  for (std::size_t i = 0; i < rays.size(); i += every) rays[used++] = rays[i];
  rays.resize(used);
  tbb::parallel_for(std::size_t{0}, shifts.size(), [&](std::size_t s) {
    barred[s] += static_cast<std::size_t>(
        std::ranges::count_if(rays, [&](const Ray& ray) { return window.barred(ray, shifts[s]); }));
  });
  return used;
}

}  // namespace

bool PathSight::doubts_path() const {
  // In a vineyard a shift by rows has 0.9 of the rays of the right path; in stands no shift has fewer.
  constexpr double sure_sigmas = 5, fewer = 0.85;
  const double sigma = std::sqrt(std::max(crossing * (1 - crossing), 1e-4) / static_cast<double>(rays));
  return crossing - crossing_there > sure_sigmas * sigma && crossing_there < fewer * crossing;
}

std::optional<PathSight> path_sight(const PointCloud& points, const PathCurve& curve, double offset_s) {
  const auto shifts = shifts_to_try();
  std::vector<std::size_t> barred(shifts.size(), 0);
  PathSight out;
  for (const double share : {0.25, 0.5, 0.75}) {
    const auto middle = curve.nearest(curve.begin_s() + share * (curve.end_s() - curve.begin_s()));
    out.rays += look_from(middle, points, curve, offset_s, shifts, barred);
  }
  if (out.rays < min_rays) return {};
  const auto best = std::ranges::min_element(barred);
  const auto share = [&](std::size_t count) { return static_cast<double>(count) / static_cast<double>(out.rays); };
  out.crossing = share(barred.front());
  out.crossing_there = share(*best);
  out.better_shift_m = shifts[static_cast<std::size_t>(best - barred.begin())];
  return out;
}

}  // namespace bole::survey
