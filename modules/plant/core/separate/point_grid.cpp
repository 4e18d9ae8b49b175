#include "plant/core/separate/point_grid.h"

#include <algorithm>
#include <numeric>

#include "base/random.h"
#include "base/statistics.h"

namespace bole::plant {

PointGrid::PointGrid(const Points3& points, double cell) : points_(&points), cell_(cell) {
  if (points.empty()) return;
  Eigen::Vector3d high = points.front();
  corner_ = points.front();
  for (const auto& p : points) {
    corner_ = corner_.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  // 21 bits hold the number of a cube along an axis.
  cell_ = std::max(cell, (high - corner_).maxCoeff() / 2'000'000);
  if (!(cell_ > 0)) cell_ = 1;
  max_cell_ = cell_of(high);
  std::vector<std::uint64_t> keys(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) keys[i] = key(cell_of(points[i]));
  order_.resize(points.size());
  std::iota(order_.begin(), order_.end(), 0u);
  std::ranges::sort(order_, [&](auto a, auto b) { return keys[a] != keys[b] ? keys[a] < keys[b] : a < b; });
  for (std::uint32_t i = 0; i < order_.size();) {
    std::uint32_t end = i;
    while (end < order_.size() && keys[order_[end]] == keys[order_[i]]) ++end;
    spans_.emplace(keys[order_[i]], Span{i, end});
    i = end;
  }
}

std::optional<PointGrid::Nearest> PointGrid::nearest(const Eigen::Vector3d& place, double max_distance) const {
  std::optional<Nearest> best;
  double best2 = 0;
  for (double radius = std::min(cell_, max_distance);; radius = std::min(radius * 2, max_distance)) {
    near(place, radius, [&](std::uint32_t i, double d2) {
      if (best && (d2 > best2 || (d2 == best2 && i > best->index))) return;
      best = Nearest{i, std::sqrt(d2)};
      best2 = d2;
    });
    if (best || radius >= max_distance) return best;
  }
}

double point_spacing(const Points3& points, std::size_t sample) {
  if (points.size() < 2) return 0;
  Eigen::Vector3d low = points.front(), high = points.front();
  for (const auto& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double size = (high - low).norm();
  if (!(size > 0)) return 0;
  // Surfaces: about sqrt(n) cubes along an edge hold one point each.
  const PointGrid grid(points, size / std::sqrt(static_cast<double>(points.size())) * 0.7);
  Random random(17, 0);
  std::vector<double> distances;
  for (std::size_t k = 0; k < std::min(sample, points.size()); ++k) {
    const auto& p = points[points.size() <= sample ? k : static_cast<std::size_t>(random.next() % points.size())];
    double best = size;
    for (double radius = size / 500; best >= size && radius <= size; radius *= 2)
      grid.near(p, radius, [&](std::uint32_t, double d2) {
        if (d2 > 0 && d2 < best * best) best = std::sqrt(d2);
      });
    if (best < size) distances.push_back(best);
  }
  return distances.empty() ? 0 : median(std::move(distances));
}

}  // namespace bole::plant
