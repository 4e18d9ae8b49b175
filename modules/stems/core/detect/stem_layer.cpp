#include "stems/core/detect/stem_layer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "cloud/core/whole/whole_cloud.h"

namespace bole::stems {
namespace {

constexpr std::size_t max_cells = std::size_t{1} << 24;

std::vector<std::uint32_t> indices_between(const PointCloud& points, float bottom, float top, const Run& run) {
  const auto& heights = points.values<float>(arrays::height_above_ground);
  const auto& positions = points.positions();
  std::vector<std::uint32_t> kept;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if ((i & 0xfffffU) == 0) run.check_cancel();
    if (heights[i] >= bottom && heights[i] <= top && positions[i].allFinite())
      kept.push_back(static_cast<std::uint32_t>(i));
  }
  return kept;
}

// Where the cells begin: at the least coordinates of the whole cloud, so that they lie the same on the stems wherever
// the cloud is moved to, whatever the ground says of points at the edge of the layer, and in a part of the cloud.
// Coordinates of files lie on a lattice, of a millimetre or a part of it; a little off it no point lies on the border
// of two cells, where rounding would decide.
constexpr double off_lattice_m = 0.000037;

}  // namespace

int StemLayer::cell_x(double x) const { return static_cast<int>(std::clamp((x - corner.x()) / cell_m, 0.0, nx - 1.0)); }
int StemLayer::cell_y(double y) const { return static_cast<int>(std::clamp((y - corner.y()) / cell_m, 0.0, ny - 1.0)); }

StemLayer make_stem_layer(const PointCloud& points, double bottom_m, double top_m, const Run& run) {
  StemLayer layer;
  const auto kept = indices_between(points, static_cast<float>(bottom_m), static_cast<float>(top_m), run);
  if (kept.empty()) return layer;
  const auto& positions = points.positions();
  Eigen::Vector2f low = positions[kept[0]].head<2>(), high = low;
  const auto polled = [&](std::size_t k) {
    if ((k & 0xfffffU) == 0) run.check_cancel();
    return kept[k];
  };
  for (const auto i : kept) low = low.cwiseMin(positions[i].head<2>()), high = high.cwiseMax(positions[i].head<2>());
  layer.anchor = grid_anchor(points, run).head<2>().array() - off_lattice_m;
  layer.corner = aligned_corner(low.cast<double>(), layer.anchor, layer.cell_m);
  const Eigen::Vector2d extent = high.cast<double>() - layer.corner;
  // A stray point far away must not cost memory: cells grow until the grid is small.
  while ((std::floor(extent.x() / layer.cell_m) + 1) * (std::floor(extent.y() / layer.cell_m) + 1) >
         static_cast<double>(max_cells))
    layer.cell_m *= 2;
  layer.nx = static_cast<int>(extent.x() / layer.cell_m) + 1,
  layer.ny = static_cast<int>(extent.y() / layer.cell_m) + 1;

  const auto cells = static_cast<std::size_t>(layer.nx) * static_cast<std::size_t>(layer.ny);
  const auto cell_of = [&](std::uint32_t i) {
    const auto& p = positions[i];
    return static_cast<std::size_t>(layer.cell_y(p.y())) * static_cast<std::size_t>(layer.nx) +
           static_cast<std::size_t>(layer.cell_x(p.x()));
  };
  layer.start.assign(cells + 1, 0);
  for (std::size_t k = 0; k < kept.size(); ++k) ++layer.start[cell_of(polled(k)) + 1];
  std::partial_sum(layer.start.begin(), layer.start.end(), layer.start.begin());
  run.check_cancel();
  auto next = layer.start;
  layer.position.resize(kept.size()), layer.height.resize(kept.size()), layer.index.resize(kept.size());
  const auto& heights = points.values<float>(arrays::height_above_ground);
  for (std::size_t j = 0; j < kept.size(); ++j) {
    const auto i = polled(j), k = next[cell_of(i)]++;
    layer.position[k] = positions[i], layer.height[k] = heights[i], layer.index[k] = i;
  }
  return layer;
}

}  // namespace bole::stems
