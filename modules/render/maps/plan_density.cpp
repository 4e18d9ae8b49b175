#include "render/maps/plan_density.h"

#include <algorithm>
#include <cmath>

namespace bole::render {

void PlanDensity::add(const Eigen::Vector2d& at) {
  const Eigen::Vector2d cell = (at - corner) / cell_m;
  if (!(cell.x() >= 0 && cell.y() >= 0 && cell.x() < width && cell.y() < height)) return;
  points[static_cast<std::size_t>(cell.y()) * static_cast<std::size_t>(width) + static_cast<std::size_t>(cell.x())] +=
      1;
}

PlanDensity plan_density(const Eigen::Vector2d& min, const Eigen::Vector2d& max, double cell_m) {
  constexpr double max_cells = 2000;  // a side
  const double longest = std::max((max - min).maxCoeff(), 0.1);
  PlanDensity plan;
  plan.cell_m = std::max(cell_m, longest / max_cells);
  plan.corner = min;
  plan.width = std::max(1, static_cast<int>(std::ceil((max.x() - min.x()) / plan.cell_m)));
  plan.height = std::max(1, static_cast<int>(std::ceil((max.y() - min.y()) / plan.cell_m)));
  plan.points.assign(static_cast<std::size_t>(plan.width) * static_cast<std::size_t>(plan.height), 0);
  return plan;
}

Image density_image(const PlanDensity& plan, double darkest) {
  std::vector<float> counts;
  for (const float n : plan.points)
    if (n > 0) counts.push_back(n);
  std::ranges::sort(counts);
  const double dense = counts.empty() ? 1 : counts[counts.size() * 99 / 100];
  Image image{plan.width, plan.height, {}};
  for (int y = plan.height - 1; y >= 0; --y)
    for (int x = 0; x < plan.width; ++x) {
      const double n =
          plan.points[static_cast<std::size_t>(y) * static_cast<std::size_t>(plan.width) + static_cast<std::size_t>(x)];
      const double t = std::min(1.0, std::log1p(n) / std::log1p(std::max(1.0, dense)));
      const auto grey = static_cast<std::uint8_t>(std::lround(255 - (255 - darkest) * t));
      image.rgba.insert(image.rgba.end(), {grey, grey, grey, 255});
    }
  return image;
}

}  // namespace bole::render
