// Points found by place.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace bole::plant {

using Points3 = std::vector<Eigen::Vector3d>;

// Points sorted into cubes. Searches are fast for radii near the edge of a cube. The points must outlive the grid.
class PointGrid {
 public:
  PointGrid(const Points3& points, double cell);

  // Calls found(index, squared distance) for every point within `radius`, in an order that does not depend on threads.
  template <class Found>
  void near(const Eigen::Vector3d& place, double radius, const Found& found) const;

  struct Nearest {
    std::uint32_t index = 0;
    double distance = 0;
  };
  // The nearest point within `max_distance`; of equal ones the first.
  std::optional<Nearest> nearest(const Eigen::Vector3d& place, double max_distance) const;

 private:
  struct Span {
    std::uint32_t begin = 0, end = 0;
  };
  Eigen::Vector3i cell_of(const Eigen::Vector3d& p) const {
    return ((p - corner_) / cell_).array().floor().cwiseMax(-2e9).cwiseMin(2e9).matrix().cast<int>();
  }
  static std::uint64_t key(const Eigen::Vector3i& c) {
    return (static_cast<std::uint64_t>(c.z()) & 0x1FFFFF) << 42 | (static_cast<std::uint64_t>(c.y()) & 0x1FFFFF) << 21 |
           (static_cast<std::uint64_t>(c.x()) & 0x1FFFFF);
  }

  const Points3* points_;
  double cell_;
  Eigen::Vector3d corner_ = Eigen::Vector3d::Zero();
  Eigen::Vector3i max_cell_ = Eigen::Vector3i::Zero();
  std::vector<std::uint32_t> order_;
  std::unordered_map<std::uint64_t, Span> spans_;
};

// The usual distance to the nearest other point: the median over at most `sample` points. 0 where there are no two
// different points.
double point_spacing(const Points3& points, std::size_t sample = 2000);

template <class Found>
void PointGrid::near(const Eigen::Vector3d& place, double radius, const Found& found) const {
  const Eigen::Vector3d reach = Eigen::Vector3d::Constant(radius);
  const Eigen::Vector3i low = cell_of(place - reach).cwiseMax(0), high = cell_of(place + reach).cwiseMin(max_cell_);
  for (int z = low.z(); z <= high.z(); ++z)
    for (int y = low.y(); y <= high.y(); ++y)
      for (int x = low.x(); x <= high.x(); ++x) {
        const auto it = spans_.find(key({x, y, z}));
        if (it == spans_.end()) continue;
        for (auto i = it->second.begin; i < it->second.end; ++i) {
          const double d2 = ((*points_)[order_[i]] - place).squaredNorm();
          if (d2 <= radius * radius) found(order_[i], d2);
        }
      }
}

}  // namespace bole::plant
