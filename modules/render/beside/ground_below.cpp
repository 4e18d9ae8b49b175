#include "render/beside/ground_below.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace bole::render {
namespace {

constexpr std::size_t looked_at = 500'000;  // points
constexpr int reach_cells = 2;

std::uint64_t cell_key(std::int64_t x, std::int64_t y) {
  return (static_cast<std::uint64_t>(x) << 32) ^ (static_cast<std::uint64_t>(y) & 0xffffffffU);
}

std::int64_t cell_index(double metres) { return static_cast<std::int64_t>(std::floor(metres)); }

}  // namespace

GroundBelow::GroundBelow(const PointCloud& cloud) {
  if (!cloud.has(arrays::height_above_ground)) return;
  const auto* heights = std::get_if<std::vector<float>>(&cloud.column(arrays::height_above_ground.name));
  if (heights == nullptr) return;
  const std::size_t step = cloud.size() / looked_at + 1;
  for (std::size_t i = 0; i < cloud.size(); i += step) {
    const Eigen::Vector3d p = cloud.position(i);
    const double z = p.z() - static_cast<double>((*heights)[i]);
    if (!std::isfinite(z) || !p.allFinite()) continue;
    auto& cell = cells_[cell_key(cell_index(p.x()), cell_index(p.y()))];
    cell.sum_z += z;
    ++cell.count;
  }
}

double GroundBelow::z_at(const Eigen::Vector2d& plan) const {
  const std::int64_t x = cell_index(plan.x()), y = cell_index(plan.y());
  for (int reach = 0; reach <= reach_cells; ++reach)
    for (int dx = -reach; dx <= reach; ++dx)
      for (int dy = -reach; dy <= reach; ++dy) {
        if (std::max(std::abs(dx), std::abs(dy)) != reach) continue;  // nearer ones were asked before
        const auto cell = cells_.find(cell_key(x + dx, y + dy));
        if (cell != cells_.end()) return cell->second.sum_z / static_cast<double>(cell->second.count);
      }
  return std::numeric_limits<double>::quiet_NaN();
}

Raster GroundBelow::heights() const {
  Raster raster;
  if (cells_.empty()) return raster;
  struct Height {
    std::int64_t x, y;
    double z;
  };
  std::vector<Height> heights;
  heights.reserve(cells_.size());
  for (const auto& [key, cell] : cells_)
    heights.push_back({static_cast<std::int64_t>(key) >> 32, static_cast<std::int32_t>(key),
                       cell.sum_z / static_cast<double>(cell.count)});
  const auto [west, east] = std::ranges::minmax(heights, {}, &Height::x);
  const auto [south, north] = std::ranges::minmax(heights, {}, &Height::y);
  raster.origin = {static_cast<double>(west.x), static_cast<double>(south.y)};
  raster.nx = static_cast<int>(east.x - west.x + 1);
  raster.ny = static_cast<int>(north.y - south.y + 1);
  raster.values.assign(static_cast<std::size_t>(raster.nx) * static_cast<std::size_t>(raster.ny),
                       std::numeric_limits<float>::quiet_NaN());
  for (const auto& [x, y, z] : heights)
    raster.at(static_cast<int>(x - west.x), static_cast<int>(y - south.y)) = static_cast<float>(z);
  return raster;
}

}  // namespace bole::render
