#include "ground/core/low_points.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace bole::ground {
namespace {

constexpr std::uint32_t none = ~std::uint32_t{0};

struct Group {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  std::size_t end = 0;  // rank by height of the first point above it
  bool found = false;
};

class GroupFinder {
 public:
  GroupFinder(const PointCloud& cloud, const PointGrid& grid, const LowPointLimits& limits, const Run& run)
      : cloud_(cloud), grid_(grid), limits_(limits), run_(run), group_of_(grid.shape().cells(), none) {
    for (std::size_t c = 0; c < group_of_.size(); ++c)
      if (!grid.points(c).empty())
        group_of_[c] = static_cast<std::uint32_t>(cells_.size()), cells_.push_back(static_cast<std::uint32_t>(c));
    groups_.resize(cells_.size());
  }

  std::vector<LowPoint> find() {
    for_each_group([&](std::size_t k) { groups_[k] = lowest_group(k, 0); });
    constexpr int max_rounds = 10;
    for (int round = 0; round < max_rounds && replace_noise(); ++round) {
    }
    std::vector<LowPoint> out;
    out.reserve(groups_.size());
    for (std::size_t k = 0; k < groups_.size(); ++k)
      if (groups_[k].found) out.push_back({groups_[k].mean, cells_[k]});
    return out;
  }

 private:
  template <class F>
  void for_each_group(const F& f) const {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, cells_.size(), 512), [&](const auto& range) {
      run_.check_cancel();
      for (std::size_t k = range.begin(); k < range.end(); ++k) f(k);
    });
  }

  // The lowest group of a cell among its points from rank `begin` upwards.
  Group lowest_group(std::size_t k, std::size_t begin) const {
    const auto by_height = grid_.points(cells_[k]);
    const auto z = [&](std::size_t rank) { return static_cast<double>(cloud_.positions()[by_height[rank]].z()); };
    const std::size_t n = by_height.size(), needed = n < 6 ? 1 : std::clamp<std::size_t>(n / 20, 2, 5);
    const double thickness = limits_.thickness_m + off_the_multiples_m;
    Group group;
    while (begin + needed <= n && z(begin + needed - 1) - z(begin) > thickness) ++begin;
    if (begin + needed > n) return group;
    for (group.end = begin; group.end < n && z(group.end) - z(begin) <= thickness; ++group.end)
      group.mean += cloud_.positions()[by_height[group.end]].cast<double>();
    group.mean /= static_cast<double>(group.end - begin);
    group.found = true;
    return group;
  }

  bool is_noise(std::size_t k) const {
    if (!groups_[k].found) return false;
    const auto& shape = grid_.shape();
    const int ix = static_cast<int>(cells_[k] % static_cast<std::uint32_t>(shape.nx)),
              iy = static_cast<int>(cells_[k] / static_cast<std::uint32_t>(shape.nx));
    int count = 0, higher = 0;
    for (int jy = iy - 2; jy <= iy + 2; ++jy)
      for (int jx = ix - 2; jx <= ix + 2; ++jx) {
        const auto other = shape.contains(jx, jy) ? group_of_[shape.index(jx, jy)] : none;
        if (other == none || other == k || !groups_[other].found) continue;
        const Eigen::Vector3d d = groups_[other].mean - groups_[k].mean;
        ++count;
        higher += d.z() > limits_.max_slope_tan * d.head<2>().norm() + limits_.thickness_m ? 1 : 0;
      }
    return count >= 4 && 2 * higher > count;
  }

  bool replace_noise() {
    std::vector<char> noise(groups_.size());
    for_each_group([&](std::size_t k) { noise[k] = is_noise(k); });
    for_each_group([&](std::size_t k) {
      if (noise[k]) groups_[k] = lowest_group(k, groups_[k].end);
    });
    return std::find(noise.begin(), noise.end(), 1) != noise.end();
  }

  const PointCloud& cloud_;
  const PointGrid& grid_;
  LowPointLimits limits_;
  const Run& run_;
  std::vector<std::uint32_t> cells_;     // that have points
  std::vector<std::uint32_t> group_of_;  // index into cells_ of each cell of the grid, or none
  std::vector<Group> groups_;
};

}  // namespace

std::vector<LowPoint> lowest_groups(const PointCloud& cloud, const PointGrid& grid, const LowPointLimits& limits,
                                    const Run& run) {
  return GroupFinder(cloud, grid, limits, run).find();
}

}  // namespace bole::ground
