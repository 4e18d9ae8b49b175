#include "views/scene_drawing.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace bole::desktop {

std::vector<Eigen::Vector3d> ring_about(const Eigen::Vector3d& middle, const Eigen::Vector3d& normal, double radius_m) {
  constexpr int sides = 24;
  const Eigen::Vector3d u = normal.unitOrthogonal(), v = normal.cross(u);
  std::vector<Eigen::Vector3d> corners;
  for (int i = 0; i <= sides; ++i) {
    const double a = 2 * std::numbers::pi * i / sides;
    corners.emplace_back(middle + radius_m * (std::cos(a) * u + std::sin(a) * v));
  }
  return corners;
}

void add_to(render::ViewFurniture& furniture, const SceneDrawing& drawing, const render::PickView& view,
            double sheet_mm_per_px) {
  const auto sheet = [&](const Eigen::Vector2d& px) {
    return Eigen::Vector2d(px.x() * sheet_mm_per_px, furniture.height_mm - px.y() * sheet_mm_per_px);
  };
  for (const auto& line : drawing.lines) {
    for (std::size_t k = 0; k + 1 < line.size(); ++k)
      if (const auto ends = render::segment_on_screen(view, line[k], line[k + 1]))
        furniture.lines.push_back({{sheet(ends->first), sheet(ends->second)}, drawing.strong, drawing.warning});
  }
  for (const auto& places : {drawing.marks, drawing.strong ? drawing.grips : std::vector<Eigen::Vector3d>()})
    for (const auto& place : places)
      if (const auto at = render::on_screen(view, place)) furniture.marks_mm.push_back(sheet(at->px));
  if (const auto at = render::on_screen(view, drawing.label_at); at && !drawing.label.empty())
    furniture.labels.push_back({sheet(at->px), drawing.label, drawing.strong});
}

std::optional<Eigen::Vector3d> dragged_to(const Grip& grip, const render::PickView& view,
                                          const Eigen::Vector2d& at_px) {
  if (grip.rail) return render::on_line(view, at_px, grip.at, *grip.rail);
  return render::on_plane(view, at_px, grip.at.z());
}

double distance_px(const SceneDrawing& drawing, const render::PickView& view, const Eigen::Vector2d& at_px) {
  double nearest_px = std::numeric_limits<double>::infinity();
  for (const auto& line : drawing.lines)
    for (std::size_t k = 0; k + 1 < line.size(); ++k)
      if (const auto ends = render::segment_on_screen(view, line[k], line[k + 1])) {
        const Eigen::Vector2d along = ends->second - ends->first;
        const double t = std::clamp((at_px - ends->first).dot(along) / std::max(along.squaredNorm(), 1e-12), 0.0, 1.0);
        nearest_px = std::min(nearest_px, (at_px - ends->first - t * along).norm());
      }
  return nearest_px;
}

}  // namespace bole::desktop
