#include "slam/core/map/distribution_map.h"

#include <tbb/parallel_for.h>

#include <Eigen/Eigenvalues>
#include <bit>
#include <cmath>

#include "slam/core/map/grid_key.h"

namespace bole::slam {
namespace {

constexpr std::uint64_t no_key = ~0ull;
constexpr std::size_t first_slots = 1 << 10;
using Cell3 = Eigen::Matrix<std::int64_t, 3, 1>;

std::uint64_t block_key(const Cell3& c) { return pack_cell(c.x() >> 2, c.y() >> 2, c.z() >> 2); }
Cell3 cell_of(const HalfCell& place, int level) {
  return place.cast<std::int64_t>().unaryExpr([=](std::int64_t half_cells) { return half_cells >> (level + 1); });
}
// The corner that is nearest to a place.
Cell3 corner_of(const HalfCell& place, int level) {
  return place.cast<std::int64_t>().unaryExpr(
      [=](std::int64_t half_cells) { return (half_cells + (std::int64_t{1} << level)) >> (level + 1); });
}
std::size_t place_in_block(const Cell3& c) {
  return static_cast<std::size_t>((c.x() & 3) | ((c.y() & 3) << 2) | ((c.z() & 3) << 4));
}

}  // namespace

DistributionMap::DistributionMap(double finest_cell_size) : levels_(levels), half_cell_size_(0.5 * finest_cell_size) {
  for (int l = 0; l < levels; ++l) levels_[static_cast<std::size_t>(l)].cell_size = std::ldexp(finest_cell_size, l);
  clear();
}

void DistributionMap::clear() {
  for (auto& level : levels_) level.clear();
}

void DistributionMap::Level::clear() {
  slots.assign(std::max(first_slots, slots.size()), Slot{});
  blocks.clear();
  cells.clear();
  last_key = no_key;
}

std::uint32_t DistributionMap::Level::block_at(std::uint64_t key) {
  if (2 * (blocks.size() + 1) > slots.size()) grow();
  const std::size_t mask = slots.size() - 1;
  for (std::size_t i = mix_bits(key) & mask;; i = (i + 1) & mask) {
    if (slots[i].key == key) return slots[i].block;
    if (slots[i].key == no_key) {
      slots[i] = {key, static_cast<std::uint32_t>(blocks.size())};
      blocks.emplace_back();
      return slots[i].block;
    }
  }
}

const DistributionMap::Block* DistributionMap::Level::find_block(std::uint64_t key) const {
  const std::size_t mask = slots.size() - 1;
  for (std::size_t i = mix_bits(key) & mask;; i = (i + 1) & mask) {
    if (slots[i].key == key) return &blocks[slots[i].block];
    if (slots[i].key == no_key) return nullptr;
  }
}

void DistributionMap::Level::grow() {
  std::vector<Slot> old(slots.size() * 2);
  old.swap(slots);
  const std::size_t mask = slots.size() - 1;
  for (const auto& slot : old) {
    if (slot.key == no_key) continue;
    std::size_t i = mix_bits(slot.key) & mask;
    while (slots[i].key != no_key) i = (i + 1) & mask;
    slots[i] = slot;
  }
}

void DistributionMap::insert(std::span<const Eigen::Vector3d> points, std::span<const std::uint16_t> line_bits,
                             CellNumbers* numbers) {
  tbb::parallel_for(std::size_t{0}, levels_.size(),
                    [&](std::size_t l) { levels_[l].insert(points, line_bits, numbers ? &(*numbers)[l] : nullptr); });
}

// Blocks and cells lie all over memory. The points of a batch call for their blocks, then for their cells, then they
// are added: so that they wait for memory together and not one after the other.
void DistributionMap::Level::insert(std::span<const Eigen::Vector3d> points, std::span<const std::uint16_t> line_bits,
                                    std::vector<std::uint32_t>* numbers) {
  struct Placed {
    std::uint32_t block, cell;
    std::size_t place;
    Eigen::Vector3f from_centre;
  };
  constexpr std::size_t batch = 32;
  std::array<Placed, batch> placed;
  for (std::size_t begin = 0; begin < points.size(); begin += batch) {
    const std::size_t n = std::min(batch, points.size() - begin);
    for (std::size_t i = 0; i < n; ++i) {
      const Eigen::Vector3d in_cells = points[begin + i] / cell_size;
      const Eigen::Vector3d corner(std::floor(in_cells.x()), std::floor(in_cells.y()), std::floor(in_cells.z()));
      const Cell3 c = corner.cast<std::int64_t>();
      if (const auto key = block_key(c); key != last_key) {
        last_block = block_at(key);
        last_key = key;
      }
      placed[i] = {last_block, 0, place_in_block(c),
                   ((in_cells - corner).array() - 0.5).matrix().cast<float>() * static_cast<float>(cell_size)};
      __builtin_prefetch(&blocks[last_block].cell[placed[i].place], 1);
    }
    for (std::size_t i = 0; i < n; ++i) {
      std::uint32_t& number = blocks[placed[i].block].cell[placed[i].place];
      if (number == 0) {
        cells.emplace_back();
        number = static_cast<std::uint32_t>(cells.size());
      }
      placed[i].cell = number - 1;
      __builtin_prefetch(&cells[placed[i].cell], 1);
      if (numbers) numbers->push_back(placed[i].cell);
    }
    for (std::size_t i = 0; i < n; ++i)
      cells[placed[i].cell].add(placed[i].from_centre, line_bits.empty() ? std::uint16_t{0} : line_bits[begin + i]);
  }
}

void DistributionMap::Cell::add(const Eigen::Vector3f& d, std::uint16_t line_bit) {
  if (count >= max_per_cell) return;
  ++count;
  lines |= line_bit;
  sum += d;
  second[0] += d.x() * d.x();
  second[1] += d.x() * d.y();
  second[2] += d.x() * d.z();
  second[3] += d.y() * d.y();
  second[4] += d.y() * d.z();
  second[5] += d.z() * d.z();
}

// The cells that meet in a corner, null where there is none. Bit k of the index: the upper one along axis k.
std::array<const DistributionMap::Cell*, 8> DistributionMap::Level::cells_about(const Cell3& corner) const {
  // Along an axis whose corner lies between two blocks, the lower and upper cells are in different blocks.
  const unsigned between = (corner.x() & 3 ? 0u : 1u) | (corner.y() & 3 ? 0u : 2u) | (corner.z() & 3 ? 0u : 4u);
  const Cell3 low = corner.array() - 1;
  const std::array<std::size_t, 2> x{static_cast<std::size_t>(low.x() & 3), static_cast<std::size_t>(corner.x() & 3)},
      y{static_cast<std::size_t>(low.y() & 3) << 2, static_cast<std::size_t>(corner.y() & 3) << 2},
      z{static_cast<std::size_t>(low.z() & 3) << 4, static_cast<std::size_t>(corner.z() & 3) << 4};
  std::array<const Block*, 8> blocks_met{};
  std::array<const Cell*, 8> met{};
  for (unsigned k = 0; k < 8; ++k) {
    const unsigned of_block = k & between;
    if (of_block == k) blocks_met[k] = find_block(block_key(low + Cell3(k & 1, (k >> 1) & 1, k >> 2)));
    if (!blocks_met[of_block]) continue;
    if (const auto place = blocks_met[of_block]->cell[x[k & 1] | y[(k >> 1) & 1] | z[k >> 2]]; place > 0)
      met[k] = &cells[place - 1];
  }
  return met;
}

void DistributionMap::Moments::add(const Cell& cell, const Eigen::Vector3d& centre) {
  const Eigen::Vector3d s = cell.sum.cast<double>(), moved = s + cell.count * centre;
  count += cell.count;
  lines |= cell.lines;
  sum += moved;
  const float* own = cell.second;
  for (int c = 0, of_own = 0; c < 3; ++c)
    for (int r = c; r < 3; ++r, ++of_own) second(r, c) += own[of_own] + s[r] * centre[c] + centre[r] * moved[c];
}

LocalSurface DistributionMap::Moments::surface(const Eigen::Vector3d& place, int level) const {
  const double n = count;
  LocalSurface surface;
  const Eigen::Vector3d mean = sum / n;
  const Eigen::Matrix3d covariance = second / n - mean * mean.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance);
  surface.mean = place + mean;
  surface.deviations = solver.eigenvalues().cwiseMax(1e-12).cwiseSqrt();
  surface.axes = solver.eigenvectors();
  surface.points = count;
  surface.lines = std::popcount(lines);
  surface.level = level;
  return surface;
}

void DistributionMap::call_for(std::span<const HalfCell> places, int level_index) const {
  const Level& level = levels_[static_cast<std::size_t>(level_index)];
  const auto for_each_corner = [&](auto&& call) {
    for (const auto& place : places) call(corner_of(place, level_index));
  };
  const auto for_both_blocks = [](const Cell3& corner, auto&& call) {
    const Cell3 low = corner.array() - 1;
    call(low);
    if (block_key(low) != block_key(corner)) call(corner);
  };
  for_each_corner([&](const Cell3& corner) {
    for_both_blocks(corner, [&](const Cell3& cell) {
      __builtin_prefetch(&level.slots[mix_bits(block_key(cell)) & (level.slots.size() - 1)]);
    });
  });
  for_each_corner([&](const Cell3& corner) {
    for_both_blocks(corner, [&](const Cell3& cell) {
      if (const Block* block = level.find_block(block_key(cell)))
        for (const std::int64_t z : {cell.z(), corner.z()})
          __builtin_prefetch(&block->cell[place_in_block({cell.x(), cell.y(), z})]);
    });
  });
  for_each_corner([&](const Cell3& corner) {
    for (const Cell* cell : level.cells_about(corner))
      if (cell) __builtin_prefetch(cell);
  });
}

// The 2 x 2 x 2 cells whose common corner is nearest to the place. Moments are moved to that corner before they are
// added.
std::optional<LocalSurface> DistributionMap::surface(const HalfCell& place, int level_index, int min_points) const {
  const Level& level = levels_[static_cast<std::size_t>(level_index)];
  const double half = 0.5 * level.cell_size;
  const Cell3 corner = corner_of(place, level_index);
  const auto met = level.cells_about(corner);
  int points = 0;
  for (const Cell* cell : met) points += cell ? cell->count : 0;
  if (points < min_points) return std::nullopt;
  Moments moments;
  for (std::size_t k = 0; k < met.size(); ++k)
    if (met[k]) moments.add(*met[k], {k & 1 ? half : -half, k & 2 ? half : -half, k & 4 ? half : -half});
  return moments.surface(level.cell_size * corner.cast<double>(), level_index);
}

Eigen::Vector3d DistributionMap::centre_at(const HalfCell& place, int level) const {
  return (cell_of(place, level).cast<double>().array() + 0.5).matrix() * cell_size(level);
}

std::optional<LocalSurface> DistributionMap::cell_surface(int level, std::size_t number, int min_points) const {
  const Cell& cell = levels_[static_cast<std::size_t>(level)].cells[number];
  if (cell.count < min_points) return std::nullopt;
  Moments moments;
  moments.add(cell, Eigen::Vector3d::Zero());
  return moments.surface(Eigen::Vector3d::Zero(), level);
}

}  // namespace bole::slam
