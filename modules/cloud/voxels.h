// Points gathered into small cubes.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstdint>
#include <vector>

namespace bole {
inline namespace cloud {

// A cube's integer coordinates as one number that sorts by z, then y, then x. Coordinates beyond +-2^20 cells are
// clamped.
inline std::uint64_t voxel_key(const Eigen::Vector3d& p, double cell_m) {
  const auto part = [cell_m](double v) {
    constexpr double half = 1 << 20;
    const double c = std::floor(v / cell_m) + half;
    return static_cast<std::uint64_t>(c < 0 ? 0 : c > 2 * half - 1 ? 2 * half - 1 : c);
  };
  return part(p.z()) << 42 | part(p.y()) << 21 | part(p.x());
}

// Number of the connected group of each key (cubes that touch by a face, edge or corner), groups counted from 0 in
// order of their first key. `keys` ascend without repeats.
std::vector<std::uint32_t> connected_groups(const std::vector<std::uint64_t>& keys);

}  // namespace cloud
}  // namespace bole
