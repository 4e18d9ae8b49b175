// The points of a plot in cubic cells: what crowns are grown in.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/run.h"
#include "cloud/point_cloud.h"

namespace bole::stems {

// Cells that hold points, numbered from 0 ("nodes"). Positions are offsets from the cloud's origin, metres.
class CrownCells {
 public:
  static constexpr std::uint32_t none = 0xffffffffU;

  // Cells of `cell_m` in the box from `low` to `high`, larger ones where these would be too many for the memory. Points
  // on the ground (below `bottom_m` above it) and points classified as noise are left out.
  CrownCells(const PointCloud& points, const Eigen::Vector3d& low, const Eigen::Vector3d& high, double cell_m,
             double bottom_m, const Run& run);

  // Cells `times` as large over the same box.
  CrownCells coarser(int times) const;

  double cell_m() const { return cell_m_; }
  std::size_t nodes() const { return place_.size(); }
  std::uint32_t node_at(const Eigen::Vector3d& p) const;
  Eigen::Vector3d middle(std::uint32_t node) const {
    return low_ + cell_m_ * (place_[node].cast<double>().array() + 0.5).matrix();
  }

  // Calls f(neighbour, dx, dy, dz) for all nodes within `reach` cells along each axis.
  template <class F>
  void for_each_near(std::uint32_t node, int reach, F&& f) const {
    const Eigen::Vector3i p = place_[node];
    for (int z = std::max(0, p.z() - reach); z <= std::min(size_.z() - 1, p.z() + reach); ++z)
      for (int y = std::max(0, p.y() - reach); y <= std::min(size_.y() - 1, p.y() + reach); ++y) {
        const std::uint32_t* row = &node_[index(0, y, z)];
        for (int x = std::max(0, p.x() - reach); x <= std::min(size_.x() - 1, p.x() + reach); ++x)
          if (row[x] != none && row[x] != node) f(row[x], x - p.x(), y - p.y(), z - p.z());
      }
  }

 private:
  CrownCells() = default;
  std::size_t index(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(size_.y()) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(size_.x()) +
           static_cast<std::size_t>(x);
  }
  std::optional<Eigen::Vector3i> cell_of(const Eigen::Vector3d& p) const;
  void number_nodes();

  Eigen::Vector3d low_ = Eigen::Vector3d::Zero();
  double cell_m_ = 0;
  Eigen::Vector3i size_ = Eigen::Vector3i::Zero();
  std::vector<std::uint32_t> node_;     // by cell
  std::vector<Eigen::Vector3i> place_;  // by node
};

}  // namespace bole::stems
