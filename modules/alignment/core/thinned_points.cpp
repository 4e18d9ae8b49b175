#include "alignment/core/thinned_points.h"

#include <algorithm>
#include <cstdint>

#include "cloud/voxels.h"

namespace bole::alignment {

Box box_of(const PointCloud& cloud) {
  Eigen::AlignedBox3f box;
  for (const auto& p : cloud.positions())
    if (p.allFinite()) box.extend(p);
  if (box.isEmpty()) return {};
  return {cloud.origin + box.min().cast<double>(), cloud.origin + box.max().cast<double>()};
}

Box grown(const Box& box, double by_m) {
  const Eigen::Vector3d by = Eigen::Vector3d::Constant(by_m);
  return {box.min() - by, box.max() + by};
}

std::vector<Eigen::Vector3f> offsets_in(const PointCloud& cloud, const Box& box, const Eigen::Vector3d& origin) {
  std::vector<Eigen::Vector3f> points;
  const Eigen::Vector3d shift = cloud.origin - origin;
  for (const auto& offset : cloud.positions())
    if (offset.allFinite() && box.contains(cloud.origin + offset.cast<double>()))
      points.emplace_back((offset.cast<double>() + shift).cast<float>());
  return points;
}

ThinnedPoints thinned(std::vector<Eigen::Vector3f> points, double cell_m, std::size_t max_points, const Run& run) {
  constexpr double coarser = 1.3;
  for (ThinnedPoints out{std::move(points), cell_m};; out.cell_m *= coarser) {
    run.check_cancel();
    std::vector<std::pair<std::uint64_t, std::uint32_t>> cells;
    cells.reserve(out.points.size());
    for (std::uint32_t i = 0; i < out.points.size(); ++i)
      cells.emplace_back(voxel_key(out.points[i].cast<double>(), out.cell_m), i);
    std::ranges::sort(cells);
    const auto rest = std::ranges::unique(cells, {}, [](const auto& cell) { return cell.first; });
    cells.erase(rest.begin(), rest.end());
    std::vector<Eigen::Vector3f> kept;
    kept.reserve(cells.size());
    for (const auto& [key, i] : cells) kept.push_back(out.points[i]);
    out.points = std::move(kept);
    if (out.points.size() <= max_points) return out;
  }
}

}  // namespace bole::alignment
