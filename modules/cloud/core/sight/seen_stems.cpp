#include "cloud/core/sight/seen_stems.h"

#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "base/statistics.h"
#include "cloud/core/sight/rough_circle.h"

namespace bole {
inline namespace cloud {
namespace sight {

namespace {

constexpr double breast_height_m = 1.3;
constexpr double half_window_m = 0.65;  // of stem above and below breast height, as the joint fit takes it

}  // namespace

void see_stems(const std::vector<StemAxis>& axes, const Sample& sample, const CellHeights& cells,
               std::optional<double> ground_z, FirstSight& out) {
  constexpr double reach_m = 0.6, grid_m = 2;
  struct Stem {
    StemAxis axis;
    double breast_height_z;
    std::vector<Eigen::Vector2d> around;
  };
  std::vector<Stem> stems;
  std::unordered_map<std::int64_t, std::vector<std::size_t>> near;
  const auto square = [](double x, double y) {
    return static_cast<std::int64_t>(std::floor(x / grid_m)) * 4'000'000 +
           static_cast<std::int64_t>(std::floor(y / grid_m));
  };
  for (const auto& a : axes) {
    // The foot of the axis, found from the ground below its middle.
    Eigen::Vector3d foot = a.middle;
    for (int round = 0; round < 2; ++round) {
      const double ground = ground_z ? *ground_z : cells.ground_around(foot.x(), foot.y(), 1);
      if (std::isnan(ground)) break;
      foot = a.middle + a.direction * ((ground - a.middle.z()) / a.direction.z());
    }
    Stem stem{a, foot.z() + breast_height_m, {}};
    stem.axis.middle = foot + a.direction * (breast_height_m / a.direction.z());
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        near[square(stem.axis.middle.x() + dx * grid_m, stem.axis.middle.y() + dy * grid_m)].push_back(stems.size());
    stems.push_back(std::move(stem));
  }
  for (const auto& p : sample.points) {
    const auto it = near.find(square(p.x(), p.y()));
    if (it == near.end()) continue;
    for (const auto k : it->second) {
      auto& s = stems[k];
      if (std::abs(static_cast<double>(p.z()) - s.breast_height_z) > half_window_m) continue;
      const Eigen::Vector3d off = p.cast<double>() - s.axis.middle;
      const Eigen::Vector3d across = off - off.dot(s.axis.direction) * s.axis.direction;
      if (across.norm() < reach_m) s.around.emplace_back(across.head<2>());
    }
  }
  std::vector<double> counts, diameters;
  std::vector<RoughCircle> circles;
  for (auto& s : stems) {
    circles.push_back(rough_circle(std::move(s.around)));
    counts.push_back(sample.each * static_cast<double>(circles.back().points.size()));
    if (std::isfinite(circles.back().radius_m)) diameters.push_back(2 * circles.back().radius_m);
  }
  see_doubled_walls(circles, out);
  out.stems = stems.size();
  if (!counts.empty()) out.points_per_stem = median(std::move(counts));
  if (!diameters.empty()) out.stem_diameter_m = median(std::move(diameters));
}

}  // namespace sight
}  // namespace cloud
}  // namespace bole
