#include "render/scene/thin.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>

namespace bole::render {
namespace {

constexpr double min_voxel_m = 0.01;
constexpr std::size_t copies_between_polls = 0x40000;  // points between two looks at the cancel flag
constexpr std::size_t candidates_per_point =
    8;                                         // of the cloud, for each point that is wanted: evenly through its order
constexpr std::size_t share_sample = 100'000;  // points that tell how much of the cloud lies in the window
constexpr unsigned min_table_bits = 20, max_table_bits = 28;  // of the occupied voxels
constexpr std::size_t slots_per_point = 64;                   // about one point in a hundred is lost to a collision

std::uint64_t scrambled(std::uint64_t v) {
  v ^= v >> 30, v *= 0xbf58476d1ce4e5b9ULL;
  v ^= v >> 27, v *= 0x94d049bb133111ebULL;
  return v ^ v >> 31;
}

// Keeps the first point of every voxel. Occupied voxels are bits at their hash.
std::vector<std::uint32_t> one_per_voxel(const PointCloud& cloud, const std::vector<std::uint32_t>& indices,
                                         double voxel_m, const Run& run) {
  const auto table_bits = std::clamp(static_cast<unsigned>(std::bit_width(slots_per_point * indices.size())),
                                     min_table_bits, max_table_bits);
  std::vector<std::uint64_t> occupied(std::size_t{1} << (table_bits - 6));
  std::vector<std::uint32_t> kept;
  const float per_metre = static_cast<float>(1 / voxel_m);
  const auto& positions = cloud.positions();
  for (std::size_t k = 0; k < indices.size(); ++k) {
    if (k % copies_between_polls == 0) run.check_cancel();
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

// Of a large cloud not every point is looked at: some for each that is wanted are enough for an even choice.
std::size_t candidate_step(std::size_t points, std::size_t budget, const std::function<bool(std::size_t)>& shown) {
  const std::size_t wanted = candidates_per_point * std::max<std::size_t>(budget, 1);
  if (points <= wanted) return 1;
  std::size_t tried = 0, inside = 0;
  for (std::size_t i = 0; i < points; i += std::max<std::size_t>(1, points / share_sample), ++tried)
    inside += shown(i) ? 1 : 0;
  const double share = static_cast<double>(inside) / static_cast<double>(std::max<std::size_t>(tried, 1));
  return std::max<std::size_t>(
      1, static_cast<std::size_t>(share * static_cast<double>(points) / static_cast<double>(wanted)));
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
  const auto shown = [&](std::size_t i) {
    const auto p = cloud.position(i);
    return p.allFinite() && window.contains(p);
  };
  const std::size_t step = candidate_step(cloud.size(), budget, shown);
  for (std::size_t i = 0, k = 0; i < cloud.size(); i += step, ++k) {
    if (k % copies_between_polls == 0) run.check_cancel();
    if (shown(i)) kept.push_back(static_cast<std::uint32_t>(i));
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
