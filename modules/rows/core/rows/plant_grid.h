// Neighbours of plants in the plane.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace bole::rows {

using Points2 = std::vector<Eigen::Vector2d>;

// A hash grid over points; cells hold a few points each. `points` must outlive it and be finite.
class PlantGrid {
 public:
  explicit PlantGrid(const Points2& points);

  // Indices of the `count` points nearest to point `i`, itself left out, nearest first; ties by index.
  std::vector<int> nearest(int i, int count) const;

  // Indices of the points within `radius` of `centre`, in ascending order.
  std::vector<int> within(const Eigen::Vector2d& centre, double radius) const;

 private:
  std::int64_t key(std::int64_t cx, std::int64_t cy) const { return (cx << 32) ^ (cy & 0xffffffff); }
  std::int64_t cell(double v) const;
  const Points2& points_;
  double cell_m_ = 1;
  double extent_m_ = 0;
  std::unordered_map<std::int64_t, std::vector<int>> cells_;
};

}  // namespace bole::rows
