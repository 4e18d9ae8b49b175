#include "render/scene/thin.h"

#include <algorithm>
#include <cmath>

namespace bole::render {
namespace {

constexpr double min_voxel_m = 0.01;
constexpr std::size_t poll_every = 0x40000;  // points between two looks at the cancel flag
constexpr unsigned table_bits = 28;  // 32 MiB: among 3 M kept points about one in a hundred is lost to a collision

std::uint64_t scrambled(std::uint64_t v) {
  v ^= v >> 30, v *= 0xbf58476d1ce4e5b9ULL;
  v ^= v >> 27, v *= 0x94d049bb133111ebULL;
  return v ^ v >> 31;
}

// Keeps the first point of every voxel. Occupied voxels are bits at their hash.
std::vector<std::uint32_t> one_per_voxel(const PointCloud& cloud, const std::vector<std::uint32_t>& indices,
                                         double voxel_m, const Run& run) {
  std::vector<std::uint64_t> occupied(std::size_t{1} << (table_bits - 6));
  std::vector<std::uint32_t> kept;
  const float per_metre = static_cast<float>(1 / voxel_m);
  const auto& positions = cloud.positions();
  for (std::size_t k = 0; k < indices.size(); ++k) {
    if (k % poll_every == 0) run.check_cancel();
    const auto i = indices[k];
    const Eigen::Vector3f v = (positions[i] * per_metre).array().floor();
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis)
      key = key * 0x9e3779b97f4a7c15ULL + static_cast<std::uint64_t>(static_cast<std::int64_t>(v[axis]));
    const std::uint64_t slot = scrambled(key) >> (64 - table_bits);
    auto& word = occupied[slot >> 6];
    const std::uint64_t bit = std::uint64_t{1} << (slot & 63);
    if ((word & bit) != 0) continue;
    word |= bit;
    kept.push_back(i);
  }
  return kept;
}

}  // namespace

Window middle_window(const PointCloud& cloud, double share) {
  constexpr std::size_t sample = 20000;
  std::vector<double> x, y;
  const std::size_t step = std::max<std::size_t>(1, cloud.size() / sample);
  for (std::size_t i = 0; i < cloud.size(); i += step)
    if (const auto p = cloud.position(i); p.allFinite()) x.push_back(p.x()), y.push_back(p.y());
  if (x.empty()) return {};
  const auto ends = [&](std::vector<double>& v) {
    std::sort(v.begin(), v.end());
    const auto cut = static_cast<std::size_t>((1 - share) / 2 * static_cast<double>(v.size()));
    return Eigen::Vector2d(v[cut], v[v.size() - 1 - cut]);
  };
  const auto ex = ends(x), ey = ends(y);
  return {{ex.x(), ey.x()}, {ex.y(), ey.y()}};
}

std::vector<std::uint32_t> thin_for_drawing(const PointCloud& cloud, const Window& window, std::size_t budget,
                                            const Run& run) {
  std::vector<std::uint32_t> kept;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (i % poll_every == 0) run.check_cancel();
    if (const auto p = cloud.position(i); p.allFinite() && window.contains(p))
      kept.push_back(static_cast<std::uint32_t>(i));
  }
  // Points lie on surfaces: their number goes with the square of the voxel size.
  for (double voxel_m = min_voxel_m; kept.size() > budget && voxel_m < 100;) {
    kept = one_per_voxel(cloud, kept, voxel_m, run);
    voxel_m *= std::max(
        1.15, std::sqrt(static_cast<double>(kept.size()) / static_cast<double>(std::max<std::size_t>(budget, 1))));
  }
  return kept;
}

}  // namespace bole::render
