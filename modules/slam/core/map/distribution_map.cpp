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
std::size_t place_in_block(const Cell3& c) {
  return static_cast<std::size_t>((c.x() & 3) | ((c.y() & 3) << 2) | ((c.z() & 3) << 4));
}

}  // namespace

DistributionMap::DistributionMap(double finest_cell_size) : levels_(levels) {
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
}

DistributionMap::Block& DistributionMap::Level::block_at(std::uint64_t key) {
  if (2 * (blocks.size() + 1) > slots.size()) grow();
  const std::size_t mask = slots.size() - 1;
  for (std::size_t i = mix_bits(key) & mask;; i = (i + 1) & mask) {
    if (slots[i].key == key) return blocks[slots[i].block];
    if (slots[i].key == no_key) {
      slots[i] = {key, static_cast<std::uint32_t>(blocks.size())};
      return blocks.emplace_back();
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

void DistributionMap::insert(const Eigen::Vector3d& point, std::uint16_t line_bit) {
  for (auto& level : levels_) level.insert(point, line_bit);
}

void DistributionMap::insert(std::span<const Eigen::Vector3d> points, std::span<const std::uint16_t> line_bits) {
  tbb::parallel_for(std::size_t{0}, levels_.size(), [&](std::size_t l) {
    for (std::size_t i = 0; i < points.size(); ++i) levels_[l].insert(points[i], line_bits.empty() ? 0 : line_bits[i]);
  });
}

void DistributionMap::Level::insert(const Eigen::Vector3d& point, std::uint16_t line_bit) {
  const Eigen::Vector3d in_cells = point / cell_size;
  const Eigen::Vector3d corner(std::floor(in_cells.x()), std::floor(in_cells.y()), std::floor(in_cells.z()));
  const Cell3 c = corner.cast<std::int64_t>();
  std::uint32_t& place = block_at(block_key(c)).cell[place_in_block(c)];
  if (place == 0) {
    cells.emplace_back();
    place = static_cast<std::uint32_t>(cells.size());
  }
  Cell& cell = cells[place - 1];
  if (cell.count >= max_per_cell) return;
  const Eigen::Vector3f d = ((in_cells - corner).array() - 0.5).matrix().cast<float>() * static_cast<float>(cell_size);
  ++cell.count;
  cell.lines |= line_bit;
  cell.sum += d;
  cell.second[0] += d.x() * d.x();
  cell.second[1] += d.x() * d.y();
  cell.second[2] += d.x() * d.z();
  cell.second[3] += d.y() * d.y();
  cell.second[4] += d.y() * d.z();
  cell.second[5] += d.z() * d.z();
}

// The cells that meet in a corner, null where there is none. Bit k of the index: the upper one along axis k.
std::array<const DistributionMap::Cell*, 8> DistributionMap::Level::cells_about(const Cell3& corner) const {
  // Along an axis whose corner lies between two blocks, the lower and upper cells are in different blocks.
  const unsigned between = (corner.x() & 3 ? 0u : 1u) | (corner.y() & 3 ? 0u : 2u) | (corner.z() & 3 ? 0u : 4u);
  std::array<const Block*, 8> blocks_met{};
  std::array<const Cell*, 8> met{};
  for (unsigned k = 0; k < 8; ++k) {
    const Cell3 c(corner.x() - 1 + (k & 1), corner.y() - 1 + ((k >> 1) & 1), corner.z() - 1 + (k >> 2));
    const unsigned of_block = k & between;
    if (of_block == k) blocks_met[k] = find_block(block_key(c));
    if (!blocks_met[of_block]) continue;
    if (const auto place = blocks_met[of_block]->cell[place_in_block(c)]; place > 0) met[k] = &cells[place - 1];
  }
  return met;
}

const DistributionMap::Cell* DistributionMap::Level::find_cell(const Cell3& c) const {
  const Block* block = find_block(block_key(c));
  const auto place = block ? block->cell[place_in_block(c)] : 0;
  return place > 0 ? &cells[place - 1] : nullptr;
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

// The 2 x 2 x 2 cells whose common corner is nearest to the point. Moments are moved to that corner before they are
// added.
std::optional<LocalSurface> DistributionMap::surface(const Eigen::Vector3d& point, int level_index,
                                                     int min_points) const {
  const Level& level = levels_[static_cast<std::size_t>(level_index)];
  const double cell_size = level.cell_size, half = 0.5 * cell_size;
  const Cell3 corner(std::llround(point.x() / cell_size), std::llround(point.y() / cell_size),
                     std::llround(point.z() / cell_size));
  const auto met = level.cells_about(corner);
  int points = 0;
  for (const Cell* cell : met) points += cell ? cell->count : 0;
  if (points < min_points) return std::nullopt;
  Moments moments;
  for (std::size_t k = 0; k < met.size(); ++k)
    if (met[k]) moments.add(*met[k], {k & 1 ? half : -half, k & 2 ? half : -half, k & 4 ? half : -half});
  return moments.surface(cell_size * corner.cast<double>(), level_index);
}

std::optional<LocalSurface> DistributionMap::cell_surface(const Eigen::Vector3d& point, int level_index,
                                                          int min_points) const {
  const Level& level = levels_[static_cast<std::size_t>(level_index)];
  const Eigen::Vector3d in_cells = (point / level.cell_size).array().floor();
  const Cell* cell = level.find_cell(in_cells.cast<std::int64_t>());
  if (!cell || cell->count < min_points) return std::nullopt;
  Moments moments;
  moments.add(*cell, Eigen::Vector3d::Zero());
  return moments.surface((in_cells.array() + 0.5).matrix() * level.cell_size, level_index);
}

}  // namespace bole::slam
