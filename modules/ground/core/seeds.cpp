#include "ground/core/seeds.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "cloud/core/whole/whole_cloud.h"
#include "ground/core/local_plane.h"

namespace bole::ground {
namespace {

template <class Points, class Position>
GridShape shape_over(const Points& points, double cell_m, const Eigen::Vector2d& anchor, const Position& position) {
  GridShape shape;
  shape.cell_m = cell_m;
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (const auto& p : points) low = low.cwiseMin(position(p)), high = high.cwiseMax(position(p));
  if (points.empty()) return shape;
  shape.corner = aligned_corner(low, anchor, cell_m);
  shape.nx = shape.column(high.x()) + 1, shape.ny = shape.row(high.y()) + 1;
  return shape;
}

// f(index) for the cells of the 5 x 5 window around (ix, iy), itself apart.
template <class F>
void for_each_near(const GridShape& shape, int ix, int iy, const F& f) {
  for (int dy = -2; dy <= 2; ++dy)
    for (int dx = -2; dx <= 2; ++dx)
      if ((dx != 0 || dy != 0) && shape.contains(ix + dx, iy + dy)) f(shape.index(ix + dx, iy + dy));
}

class SeedFinder {
 public:
  SeedFinder(const std::vector<LowPoint>& candidates, const std::vector<char>& excluded, const SeedLimits& limits)
      : candidates_(candidates),
        limits_(limits),
        keys_(candidates, limits.cell_m, limits.anchor),
        by_height_(keys_.cells()),
        rank_(keys_.cells(), 0) {
    for (std::size_t i = 0; i < candidates.size(); ++i)
      if (!excluded[i]) by_height_[keys_.key(i)].push_back(static_cast<std::uint32_t>(i));
    for (auto& cell : by_height_)
      std::stable_sort(cell.begin(), cell.end(), [&](std::uint32_t a, std::uint32_t b) {
        return candidates[a].position.z() < candidates[b].position.z();
      });
  }

  std::vector<std::uint32_t> find() {
    constexpr int max_rounds = 20;
    for (int round = 0; round < max_rounds && pass_over_low_noise(); ++round) {
    }
    return without_islands(without_high_seeds());
  }

 private:
  std::uint32_t seed(std::size_t cell) const {
    return rank_[cell] < by_height_[cell].size() ? by_height_[cell][rank_[cell]] : none;
  }

  struct Neighbours {
    int count = 0, too_high = 0, too_low = 0;  // more steeply above / below the seed than the terrain can be
  };

  Neighbours look_around(std::size_t cell) const {
    Neighbours out;
    const auto& p = candidates_[seed(cell)].position;
    for_each_near(keys_.shape(), static_cast<int>(cell % static_cast<std::size_t>(keys_.shape().nx)),
                  static_cast<int>(cell / static_cast<std::size_t>(keys_.shape().nx)), [&](std::size_t other) {
                    const auto s = seed(other);
                    if (s == none) return;
                    const Eigen::Vector3d d = candidates_[s].position - p;
                    const double most = limits_.max_slope_tan * d.head<2>().norm() + limits_.roughness_m;
                    ++out.count;
                    out.too_high += d.z() > most ? 1 : 0;
                    out.too_low += d.z() < -most ? 1 : 0;
                  });
    return out;
  }

  bool pass_over_low_noise() {
    std::vector<std::size_t> noise;
    for (std::size_t cell = 0; cell < keys_.cells(); ++cell) {
      if (seed(cell) == none) continue;
      const auto n = look_around(cell);
      if (n.count >= 3 && 2 * n.too_high > n.count) noise.push_back(cell);
    }
    for (const auto cell : noise) ++rank_[cell];
    return !noise.empty();
  }

  std::vector<std::uint32_t> without_high_seeds() const {
    std::vector<std::uint32_t> seeds;
    for (std::size_t cell = 0; cell < keys_.cells(); ++cell)
      if (seed(cell) != none && look_around(cell).too_low < 2) seeds.push_back(seed(cell));
    return seeds;
  }

  // Seeds that hang together over gaps of one cell with at least a tenth as many cells as the largest such group.
  std::vector<std::uint32_t> without_islands(const std::vector<std::uint32_t>& seeds) const {
    const auto& shape = keys_.shape();
    std::vector<std::uint32_t> island(keys_.cells(), none);
    std::vector<char> seeded(keys_.cells(), 0);
    for (const auto s : seeds) seeded[keys_.key(s)] = 1;
    std::vector<std::size_t> sizes;
    for (const auto s : seeds) {
      if (island[keys_.key(s)] != none) continue;
      const auto number = static_cast<std::uint32_t>(sizes.size());
      std::vector<std::size_t> open{keys_.key(s)};
      island[open.back()] = number;
      sizes.push_back(0);
      while (!open.empty()) {
        const auto cell = open.back();
        open.pop_back();
        ++sizes.back();
        for_each_near(shape, static_cast<int>(cell % static_cast<std::size_t>(shape.nx)),
                      static_cast<int>(cell / static_cast<std::size_t>(shape.nx)), [&](std::size_t other) {
                        if (seeded[other] && island[other] == none) island[other] = number, open.push_back(other);
                      });
      }
    }
    std::vector<std::uint32_t> out;
    const std::size_t largest = sizes.empty() ? 0 : *std::max_element(sizes.begin(), sizes.end());
    for (const auto s : seeds)
      if (sizes[island[keys_.key(s)]] * 10 >= largest) out.push_back(s);
    return out;
  }

  const std::vector<LowPoint>& candidates_;
  SeedLimits limits_;
  CellKeys keys_;
  std::vector<std::vector<std::uint32_t>> by_height_;  // candidates of each cell, lowest first
  std::vector<std::size_t> rank_;                      // of the seed among them
};

}  // namespace

CellKeys::CellKeys(const std::vector<LowPoint>& points, double cell_m, const Eigen::Vector2d& anchor) {
  shape_ =
      shape_over(points, cell_m, anchor, [](const LowPoint& p) -> Eigen::Vector2d { return p.position.head<2>(); });
  keys_.reserve(points.size());
  for (const auto& p : points)
    keys_.push_back(
        static_cast<std::uint32_t>(shape_.index(shape_.column(p.position.x()), shape_.row(p.position.y()))));
}

std::vector<std::uint32_t> find_seeds(const std::vector<LowPoint>& candidates, const std::vector<char>& excluded,
                                      const SeedLimits& limits) {
  return SeedFinder(candidates, excluded, limits).find();
}

std::vector<char> stands_above_ground(const std::vector<LowPoint>& candidates, const SeedLimits& limits, double place_m,
                                      const Run& run) {
  const CellKeys places(candidates, std::max(place_m, limits.cell_m / 8), limits.anchor);
  const auto& shape = places.shape();
  std::vector<std::uint32_t> lowest(places.cells(), none), second(places.cells(), none);
  const auto lower = [&](std::uint32_t i, std::uint32_t j) {
    return j == none || candidates[i].position.z() < candidates[j].position.z();
  };
  for (std::uint32_t i = 0; i < candidates.size(); ++i) {
    auto &a = lowest[places.key(i)], &b = second[places.key(i)];
    if (lower(i, a))
      b = a, a = i;
    else if (lower(i, b))
      b = i;
  }
  for (std::size_t c = 0; c < places.cells(); ++c)
    if (second[c] == none) second[c] = lowest[c];
  const int reach = static_cast<int>(std::ceil(limits.cell_m / shape.cell_m));
  std::vector<char> out(candidates.size(), 0);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, candidates.size(), 1024), [&](const auto& range) {
    run.check_cancel();
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const auto& p = candidates[i].position;
      const int ix = shape.column(p.x()), iy = shape.row(p.y());
      int below = 0;
      for (int jy = std::max(0, iy - reach); jy <= std::min(shape.ny - 1, iy + reach); ++jy)
        for (int jx = std::max(0, ix - reach); jx <= std::min(shape.nx - 1, ix + reach); ++jx) {
          const auto other = second[shape.index(jx, jy)];
          if (other == none) continue;
          const Eigen::Vector3d d = p - candidates[other].position;
          below += d.z() > limits.max_slope_tan * d.head<2>().norm() + limits.roughness_m ? 1 : 0;
        }
      out[i] = below >= 2;
    }
  });
  return out;
}

std::vector<Eigen::Vector3d> surrounding_points(const std::vector<Eigen::Vector3d>& ground, double cell_m,
                                                const Eigen::Vector2d& anchor) {
  std::vector<Eigen::Vector3d> out;
  if (ground.empty()) return out;
  GridShape shape =
      shape_over(ground, cell_m, anchor, [](const Eigen::Vector3d& p) -> Eigen::Vector2d { return p.head<2>(); });
  shape.corner.array() -=
      1.5 * cell_m;  // room for a ring of cells, and no ground point on the line between two cells' centres
  shape.nx += 3, shape.ny += 3;
  std::vector<Eigen::Vector4d> sums(shape.cells(), Eigen::Vector4d::Zero());  // x, y, z, count
  for (const auto& p : ground) {
    auto& s = sums[shape.index(shape.column(p.x()), shape.row(p.y()))];
    s.head<3>() += p, s(3) += 1;
  }
  for (int iy = 0; iy < shape.ny; ++iy)
    for (int ix = 0; ix < shape.nx; ++ix) {
      if (sums[shape.index(ix, iy)](3) > 0) continue;
      const Eigen::Vector2d centre = shape.centre(ix, iy);
      PlaneFit fit;
      double spread = 0;
      bool beside = false;
      for (int dy = -2; dy <= 2; ++dy)
        for (int dx = -2; dx <= 2; ++dx) {
          if (!shape.contains(ix + dx, iy + dy)) continue;
          const auto& s = sums[shape.index(ix + dx, iy + dy)];
          if (s(3) == 0) continue;
          beside = beside || (std::abs(dx) <= 1 && std::abs(dy) <= 1);
          const Eigen::Vector3d mean = s.head<3>() / s(3);
          const Eigen::Vector2d d = mean.head<2>() - centre;
          const double weight = 1.0 / (d.squaredNorm() + 1e-6);
          spread += weight * d.squaredNorm();
          fit.add(d.x(), d.y(), mean.z(), weight);
        }
      if (beside) out.emplace_back(centre.x(), centre.y(), fit.solve(0.02 * spread)(0));
    }
  return out;
}

}  // namespace bole::ground
