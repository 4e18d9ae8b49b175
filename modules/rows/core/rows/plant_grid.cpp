#include "rows/core/rows/plant_grid.h"

#include <algorithm>
#include <cmath>

namespace bole::rows {

PlantGrid::PlantGrid(const Points2& points) : points_(points) {
  if (points.empty()) return;
  Eigen::Vector2d lo = points[0], hi = points[0];
  for (const auto& p : points) {
    lo = lo.cwiseMin(p);
    hi = hi.cwiseMax(p);
  }
  extent_m_ = (hi - lo).norm();
  // About three points per cell of the box, were they spread evenly.
  const Eigen::Vector2d size = (hi - lo).cwiseMax(1e-3 * extent_m_).cwiseMax(1e-6);
  cell_m_ = std::max(std::sqrt(3 * size.prod() / static_cast<double>(points.size())), 1e-7 * (extent_m_ + 1));
  for (int i = 0; i < static_cast<int>(points.size()); ++i) {
    const auto& p = points[static_cast<std::size_t>(i)];
    cells_[key(cell(p.x()), cell(p.y()))].push_back(i);
  }
}

std::int64_t PlantGrid::cell(double v) const { return static_cast<std::int64_t>(std::floor(v / cell_m_)); }

std::vector<int> PlantGrid::within(const Eigen::Vector2d& centre, double radius) const {
  std::vector<int> found;
  const auto x0 = cell(centre.x() - radius), x1 = cell(centre.x() + radius), y0 = cell(centre.y() - radius),
             y1 = cell(centre.y() + radius);
  for (auto cx = x0; cx <= x1; ++cx)
    for (auto cy = y0; cy <= y1; ++cy)
      if (const auto it = cells_.find(key(cx, cy)); it != cells_.end())
        for (const int j : it->second)
          if ((points_[static_cast<std::size_t>(j)] - centre).norm() <= radius) found.push_back(j);
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<int> PlantGrid::nearest(int i, int count) const {
  const auto& centre = points_[static_cast<std::size_t>(i)];
  const auto wanted =
      static_cast<std::size_t>(std::min<std::int64_t>(count, static_cast<std::int64_t>(points_.size()) - 1));
  std::vector<int> found;
  for (double radius = cell_m_;; radius *= 1.6) {
    found = within(centre, radius);
    if (found.size() > wanted || radius > 2 * extent_m_ + cell_m_) break;
  }
  std::erase(found, i);
  std::stable_sort(found.begin(), found.end(), [&](int a, int b) {
    return (points_[static_cast<std::size_t>(a)] - centre).squaredNorm() <
           (points_[static_cast<std::size_t>(b)] - centre).squaredNorm();
  });
  if (found.size() > wanted) found.resize(wanted);
  return found;
}

}  // namespace bole::rows
