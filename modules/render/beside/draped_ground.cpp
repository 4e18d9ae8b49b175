#include "render/beside/draped_ground.h"

#include <algorithm>
#include <cmath>
#include <deque>

namespace bole::render {
namespace {

constexpr double below_m = 0.05;
constexpr int max_side = 192;  // places along a side: 74 000 triangles

// Heights spread from places that have one to their neighbours, one step after another.
void fill(GroundPlaces& places) {
  std::deque<std::size_t> front;
  for (std::size_t i = 0; i < places.at.size(); ++i)
    if (std::isfinite(places.at[i].z())) front.push_back(i);
  const auto columns = static_cast<std::size_t>(places.columns), rows = static_cast<std::size_t>(places.rows);
  while (!front.empty()) {
    const std::size_t i = front.front(), column = i % columns, row = i / columns;
    front.pop_front();
    const auto spread = [&](std::size_t to) {
      if (std::isfinite(places.at[to].z())) return;
      places.at[to].z() = places.at[i].z();
      front.push_back(to);
    };
    if (column > 0) spread(i - 1);
    if (column + 1 < columns) spread(i + 1);
    if (row > 0) spread(i - columns);
    if (row + 1 < rows) spread(i + columns);
  }
}

}  // namespace

GroundPlaces draped_ground(const GroundCorners& corners, const Raster& terrain, double z) {
  const Eigen::Vector2d east = corners[1] - corners[0], south = corners[3] - corners[0];
  const double step_m = std::max(terrain.cell_m, std::max(east.norm(), south.norm()) / (max_side - 1));
  GroundPlaces places{std::max(2, static_cast<int>(std::ceil(east.norm() / step_m)) + 1),
                      std::max(2, static_cast<int>(std::ceil(south.norm() / step_m)) + 1),
                      {},
                      false};
  bool known = false;
  for (int row = 0; row < places.rows; ++row)
    for (int column = 0; column < places.columns; ++column) {
      const Eigen::Vector2d at = corners[0] + east * column / (places.columns - 1) + south * row / (places.rows - 1);
      const double height = terrain.sample(at.x(), at.y());
      known = known || std::isfinite(height);
      places.at.emplace_back(at.x(), at.y(), height - below_m);
    }
  if (!known) return flat_ground(corners, z);
  fill(places);
  return places;
}

}  // namespace bole::render
