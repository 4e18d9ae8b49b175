#include "views/clouds/beside_cut.h"

#include <algorithm>

namespace bole::desktop {
namespace {

constexpr std::size_t max_dots = 20'000;

std::vector<Eigen::Vector3d> points_in(const CutCloud& cloud, const Eigen::Vector3d& lo, const Eigen::Vector3d& hi) {
  const auto& all = *cloud.points;
  std::vector<std::uint32_t> found;
  if (cloud.index) {
    found = cloud.index->in_box(all, (lo - all.origin).cast<float>(), (hi - all.origin).cast<float>());
    std::ranges::sort(found);
  } else {
    for (std::uint32_t i = 0; i < all.size(); ++i) found.push_back(i);
  }
  std::vector<Eigen::Vector3d> points;
  for (const auto i : found)
    if (const Eigen::Vector3d p = all.position(i); (p.array() >= lo.array()).all() && (p.array() <= hi.array()).all())
      points.push_back(p);
  if (points.size() > max_dots) {
    for (std::size_t k = 0; k < max_dots; ++k) points[k] = points[k * points.size() / max_dots];
    points.resize(max_dots);
  }
  return points;
}

template <class Flat>
std::vector<render::CloudDots> dots_of(const std::vector<CutCloud>& clouds, const Eigen::Vector3d& lo,
                                       const Eigen::Vector3d& hi, Flat&& flat) {
  std::vector<render::CloudDots> all;
  for (const auto& cloud : clouds) {
    render::CloudDots dots{{cloud.name, cloud.color}, {}};
    for (const auto& p : points_in(cloud, lo, hi)) dots.points.push_back(flat(p));
    all.push_back(std::move(dots));
  }
  return all;
}

}  // namespace

std::vector<render::CloudDots> dots_across(const std::vector<CutCloud>& clouds, const StemPlace& stem,
                                           const CutPlace& cut, const Eigen::Vector2d& middle, double reach_m) {
  const Eigen::Vector3d centre(middle.x(), middle.y(), stem.foot.z() + cut.height_m);
  const Eigen::Vector3d half(reach_m, reach_m, cut.thickness_m / 2);
  return dots_of(clouds, centre - half, centre + half,
                 [&](const Eigen::Vector3d& p) { return Eigen::Vector2d(p.head<2>() - middle); });
}

std::vector<render::CloudDots> dots_along(const std::vector<CutCloud>& clouds, const StemPlace& stem,
                                          const render::StemProfileData& profile) {
  const Eigen::Vector3d lo(-profile.reach_m, -profile.reach_m, 0), hi(profile.reach_m, profile.reach_m, profile.top_m);
  return dots_of(clouds, stem.foot + lo, stem.foot + hi, [&](const Eigen::Vector3d& p) {
    return Eigen::Vector2d(p.x() - stem.foot.x(), p.z() - stem.foot.z());
  });
}

}  // namespace bole::desktop
