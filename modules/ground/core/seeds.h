// Where the ground filter starts: the lowest candidates of large cells, and what surrounds them.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "ground/core/low_points.h"

namespace bole::ground {

inline constexpr std::uint32_t none = ~std::uint32_t{0};

// Cell number of each point in a grid over all of them whose cells begin at `anchor`.
class CellKeys {
 public:
  CellKeys(const std::vector<LowPoint>& points, double cell_m, const Eigen::Vector2d& anchor);
  std::uint32_t key(std::size_t point) const { return keys_[point]; }
  std::size_t cells() const { return shape_.cells(); }
  const GridShape& shape() const { return shape_; }

 private:
  GridShape shape_;
  std::vector<std::uint32_t> keys_;
};

struct SeedLimits {
  double cell_m = 4;
  double max_slope_tan = 1.2;
  double roughness_m = 0.1;
  Eigen::Vector2d anchor = Eigen::Vector2d::Zero();  // where cells begin
};

// Indices of the lowest candidate per cell, except those that lie below most neighbours more steeply than the terrain
// can fall (low noise: the next lowest is tried), and those that rise more steeply than it can above two neighbours or
// more. Small islands of seeds (far returns from crowns, strays) are left out, and candidates marked in `excluded`.
std::vector<std::uint32_t> find_seeds(const std::vector<LowPoint>& candidates, const std::vector<char>& excluded,
                                      const SeedLimits& limits);

// 1 for each candidate that lies above two or more places within `limits.cell_m` more steeply than the terrain can
// rise: the ground is seen beside it, so it is not ground (slope-based filter, Vosselman 2000). Of each place (an
// eighth of cell_m, at least `place_m`) the second lowest candidate counts, so that a stray low one does no harm.
std::vector<char> stands_above_ground(const std::vector<LowPoint>& candidates, const SeedLimits& limits, double place_m,
                                      const Run& run);

// Virtual points at the centres of empty cells beside occupied ones, on the plane through the occupied cells around
// them. The cells begin at `anchor`, half a cell aside, so that no ground point lies on the line between two centres.
std::vector<Eigen::Vector3d> surrounding_points(const std::vector<Eigen::Vector3d>& ground, double cell_m,
                                                const Eigen::Vector2d& anchor);

}  // namespace bole::ground
