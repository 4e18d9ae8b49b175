#include "views/scene_outline.h"

#include <algorithm>

namespace bole::desktop {
namespace {

double distance(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const Eigen::Vector2d ab = b - a;
  const double t = std::clamp((p - a).dot(ab) / std::max(ab.squaredNorm(), 1e-12), 0.0, 1.0);
  return (p - a - t * ab).norm();
}

}  // namespace

std::vector<Eigen::Vector2d> simplified(const std::vector<Eigen::Vector2d>& path, double tolerance_px) {
  if (path.size() < 3) return path;
  std::vector<bool> kept(path.size(), false);
  kept.front() = kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, path.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    std::size_t farthest = first;
    double most = tolerance_px;
    for (std::size_t i = first + 1; i < last; ++i)
      if (const double d = distance(path[i], path[first], path[last]); d > most) {
        most = d;
        farthest = i;
      }
    if (farthest == first) continue;
    kept[farthest] = true;
    open.emplace_back(first, farthest);
    open.emplace_back(farthest, last);
  }
  std::vector<Eigen::Vector2d> out;
  for (std::size_t i = 0; i < path.size(); ++i)
    if (kept[i]) out.push_back(path[i]);
  return out;
}

SceneOutline outline_of(const std::vector<Eigen::Vector2d>& path_px, const render::PickView& view,
                        const Eigen::Vector3d& target, const std::optional<Eigen::Vector3d>& eye) {
  SceneOutline outline{{}, eye};
  const auto on = render::on_screen(view, target);
  if (!on) return outline;
  for (const auto& px : path_px) outline.corners.push_back(render::at_depth(view, px, on->depth));
  return outline;
}

}  // namespace bole::desktop
