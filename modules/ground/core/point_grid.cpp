#include "ground/core/point_grid.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <span>
#include <tuple>

#include "base/option.h"
#include "cloud/core/whole/whole_cloud.h"

namespace bole::ground {
namespace {

constexpr std::size_t max_cells = 100'000'000;
constexpr std::size_t chunk_points = std::size_t{1} << 20;

struct Box {
  Eigen::Vector2f low = Eigen::Vector2f::Constant(std::numeric_limits<float>::infinity());
  Eigen::Vector2f high = Eigen::Vector2f::Constant(-std::numeric_limits<float>::infinity());
};

Box bounding_box(const PointCloud::Positions& positions) {
  Box box;
  for (const auto& p : positions) {
    if (!p.allFinite()) continue;
    box.low = box.low.cwiseMin(p.head<2>());
    box.high = box.high.cwiseMax(p.head<2>());
  }
  return box;
}

// Numbers in the order of the values; both zeros are one.
std::uint32_t ordered_bits(float value) {
  const auto bits = std::bit_cast<std::uint32_t>(value + 0.0F);
  return (bits & 0x80000000U) != 0 ? ~bits : bits | 0x80000000U;
}

// Keys of a height and a point, sorted: points of one height are sorted by place.
void sort_level_points(const PointCloud::Positions& positions, std::span<std::uint64_t> keys) {
  for (std::size_t first = 0, last = 0; first < keys.size(); first = last) {
    for (last = first + 1; last < keys.size() && keys[last] >> 32U == keys[first] >> 32U;) ++last;
    if (last - first > 1)
      std::ranges::sort(keys.subspan(first, last - first), {}, [&](std::uint64_t key) {
        const auto i = static_cast<std::uint32_t>(key);
        return std::tuple(positions[i].x(), positions[i].y(), i);
      });
  }
}

}  // namespace

bool fits_grid(const PointCloud& cloud, double cell_m) {
  const Box box = bounding_box(cloud.positions());
  const Eigen::Vector2d cells = ((box.high - box.low).cast<double>() / cell_m).array() + 1;
  return cells.x() * cells.y() <= static_cast<double>(max_cells);
}

GridShape grid_over(const PointCloud& cloud, double cell_m) {
  const Box box = bounding_box(cloud.positions());
  if (!(box.low.x() <= box.high.x()))
    throw bad_input("the cloud has " + std::to_string(cloud.size()) + " points, none with finite coordinates",
                    "at least one");
  GridShape shape;
  shape.cell_m = cell_m;
  const auto whole = whole_of(cloud.facts);
  const Eigen::Vector2d first = whole ? Eigen::Vector2d(grid_anchor(cloud).head<2>()) : box.low.cast<double>();
  shape.anchor = first.array() - off_the_multiples_m;
  shape.corner = whole ? aligned_corner(box.low.cast<double>(), shape.anchor, cell_m) : shape.anchor;
  const Eigen::Vector2d extent = (box.high - box.low).cast<double>(),
                        cells = ((box.high.cast<double>() - shape.corner) / cell_m).array().floor() + 1;
  if (!(cells.x() * cells.y() <= static_cast<double>(max_cells)))
    throw bad_input("the cloud covers " + number_text(std::round(extent.x())) + " by " +
                        number_text(std::round(extent.y())) + " m: too many cells of " + number_text(cell_m) + " m",
                    "at most 100 million cells",
                    "Crop the cloud (one stray point far away is enough to widen it) or raise cell");
  shape.nx = static_cast<int>(cells.x());
  shape.ny = static_cast<int>(cells.y());
  return shape;
}

PointGrid::PointGrid(const PointCloud& cloud, const GridShape& shape, const Run& run) : shape_(shape) {
  if (cloud.size() >= no_cell)
    throw bad_input("the cloud has " + std::to_string(cloud.size()) + " points", "fewer than 4 thousand million",
                    "Crop or thin the cloud first");
  count_and_scatter(cloud, run);
  sort_cells(cloud, run);
}

void PointGrid::count_and_scatter(const PointCloud& cloud, const Run& run) {
  const auto& positions = cloud.positions();
  std::vector<std::uint32_t> cell_of(positions.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, positions.size(), 1 << 17), [&](const auto& range) {
    run.check_cancel();
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const auto& p = positions[i];
      if (!p.allFinite()) {
        cell_of[i] = no_cell;
        continue;
      }
      const int ix = std::clamp(shape_.column(static_cast<double>(p.x())), 0, shape_.nx - 1),
                iy = std::clamp(shape_.row(static_cast<double>(p.y())), 0, shape_.ny - 1);
      cell_of[i] = static_cast<std::uint32_t>(shape_.index(ix, iy));
    }
  });
  start_.assign(shape_.cells() + 1, 0);
  for (std::size_t i = 0; i < cell_of.size(); ++i) {
    if (i % chunk_points == 0) run.check_cancel();
    if (cell_of[i] != no_cell) ++start_[cell_of[i] + 1];
  }
  for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
  order_.resize(start_.back());
  // start_ serves as the write position of each cell; afterwards it stands one cell too far and is shifted back.
  for (std::size_t i = 0; i < cell_of.size(); ++i) {
    if (i % chunk_points == 0) run.check_cancel();
    if (cell_of[i] != no_cell) order_[start_[cell_of[i]]++] = static_cast<std::uint32_t>(i);
  }
  for (std::size_t c = start_.size() - 1; c > 0; --c) start_[c] = start_[c - 1];
  start_[0] = 0;
}

void PointGrid::sort_cells(const PointCloud& cloud, const Run& run) {
  const auto& positions = cloud.positions();
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, shape_.cells(), 256), [&](const auto& range) {
    run.check_cancel();
    std::vector<std::uint64_t> keys;
    for (std::size_t c = range.begin(); c < range.end(); ++c) {
      keys.clear();
      for (std::uint32_t k = start_[c]; k < start_[c + 1]; ++k)
        keys.push_back((std::uint64_t{ordered_bits(positions[order_[k]].z())} << 32U) | order_[k]);
      std::sort(keys.begin(), keys.end());
      sort_level_points(positions, keys);
      for (std::size_t k = 0; k < keys.size(); ++k) order_[start_[c] + k] = static_cast<std::uint32_t>(keys[k]);
    }
  });
}

}  // namespace bole::ground
