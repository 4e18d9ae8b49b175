#include "cloud/core/sight/cell_heights.h"

#include <algorithm>
#include <cmath>

#include "base/statistics.h"
#include "cloud/core/sight/sample.h"

namespace bole {
inline namespace cloud {
namespace sight {

namespace {

std::uint64_t key(int ix, int iy) {
  return static_cast<std::uint64_t>(static_cast<std::uint32_t>(ix)) << 32 | static_cast<std::uint32_t>(iy);
}

std::pair<int, int> place(std::uint64_t key) {
  return {static_cast<int>(static_cast<std::uint32_t>(key >> 32)), static_cast<int>(static_cast<std::uint32_t>(key))};
}

// The first of `z`, sorted from the outside inwards, that has enough others of the cell behind it.
float first_not_stray(const std::vector<float>& z) {
  constexpr float near_m = 0.3F;
  constexpr double few = 0.02;
  const auto count = z.size();
  const auto needed = static_cast<std::size_t>(few * static_cast<double>(count));
  for (std::size_t i = 0; i + needed < count; ++i)
    if (std::abs(z[i + needed] - z[i]) < near_m) return z[i];
  return z[0];
}

}  // namespace

CellHeights::CellHeights(const std::vector<Eigen::Vector3f>& points, double cell_m) : cell_m_(cell_m) {
  std::unordered_map<std::uint64_t, std::vector<float>> heights;
  for (const auto& p : points) heights[key(index(p.x()), index(p.y()))].push_back(p.z());
  std::vector<double> counts;
  for (auto& [k, z] : heights) {
    std::ranges::sort(z);
    counts.push_back(static_cast<double>(z.size()));
    cells_[k] = {first_not_stray(z), first_not_stray(std::vector<float>(z.rbegin(), z.rend())),
                 static_cast<std::uint32_t>(z.size())};
  }
  constexpr double hardly_any = 0.02;
  if (!counts.empty()) min_count_ = hardly_any * upper_median(std::move(counts));
}

int CellHeights::index(double v) const { return static_cast<int>(std::floor(std::clamp(v / cell_m_, -1e9, 1e9))); }

const CellHeights::Cell* CellHeights::find(int ix, int iy) const {
  const auto it = cells_.find(key(ix, iy));
  return it == cells_.end() ? nullptr : &it->second;
}

float CellHeights::low_around(double x, double y, int cells) const {
  float low = std::numeric_limits<float>::infinity();
  for (int dy = -cells; dy <= cells; ++dy)
    for (int dx = -cells; dx <= cells; ++dx)
      if (const auto* c = find(index(x) + dx, index(y) + dy); c != nullptr && c->count >= min_count_)
        low = std::min(low, c->low);
  return std::isinf(low) ? std::numeric_limits<float>::quiet_NaN() : low;
}

double CellHeights::ground_around(double x, double y, int cells) const {
  std::vector<double> lows;
  for (int dy = -cells; dy <= cells; ++dy)
    for (int dx = -cells; dx <= cells; ++dx)
      if (const auto* c = find(index(x) + dx, index(y) + dy); c != nullptr && c->count >= min_count_)
        lows.push_back(static_cast<double>(c->low));
  return upper_median(std::move(lows));
}

double CellHeights::continuing_share(bool top) const {
  constexpr double tolerance_m = 0.15;
  std::size_t checked = 0, continuing = 0;
  const auto height = [top](const Cell& c) { return top ? c.high : c.low; };
  for (const auto& [k, c] : cells_) {
    const auto [ix, iy] = place(k);
    for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(0, 1)}) {
      const auto *before = find(ix - dx, iy - dy), *after = find(ix + dx, iy + dy);
      if (before == nullptr || after == nullptr) continue;
      ++checked;
      if (std::abs(height(c) - 0.5F * (height(*before) + height(*after))) < tolerance_m) ++continuing;
    }
  }
  constexpr std::size_t min_checked = 20;
  return checked < min_checked ? 0 : static_cast<double>(continuing) / static_cast<double>(checked);
}

double cell_size_m(const std::vector<Eigen::Vector3f>& points, int axis) {
  double area = 1;
  for (int a = 0; a < 3; ++a)
    if (a != axis) area *= std::max(0.01F, range_of(coordinates(points, a), 0.002).width());
  constexpr double points_per_cell = 4;
  return std::max(1.0, std::sqrt(points_per_cell * area / static_cast<double>(points.size())));
}

}  // namespace sight
}  // namespace cloud
}  // namespace bole
