#include "slam/core/distribution_map.h"

#include <Eigen/Eigenvalues>
#include <bit>
#include <cmath>

#include "slam/core/grid_key.h"

namespace bole {
namespace {
constexpr std::uint64_t no_key = ~0ull;
constexpr std::size_t first_slots = 1 << 12;
}  // namespace

DistributionMap::DistributionMap(double finest_cell_m) : levels_(levels) {
  for (int l = 0; l < levels; ++l) levels_[static_cast<std::size_t>(l)].cell_m = std::ldexp(finest_cell_m, l);
  clear();
}

void DistributionMap::clear() {
  for (auto& level : levels_) level.slots.assign(first_slots, Cell{}), level.used = 0;
}

DistributionMap::Cell& DistributionMap::Level::find_or_add(std::uint64_t key) {
  if (2 * (used + 1) > slots.size()) grow();
  const std::size_t mask = slots.size() - 1;
  for (std::size_t i = mix_bits(key) & mask;; i = (i + 1) & mask) {
    if (slots[i].key == key) return slots[i];
    if (slots[i].key == no_key) {
      slots[i].key = key;
      ++used;
      return slots[i];
    }
  }
}

const DistributionMap::Cell* DistributionMap::Level::find(std::uint64_t key) const {
  const std::size_t mask = slots.size() - 1;
  for (std::size_t i = mix_bits(key) & mask;; i = (i + 1) & mask) {
    if (slots[i].key == key) return &slots[i];
    if (slots[i].key == no_key) return nullptr;
  }
}

void DistributionMap::Level::grow() {
  std::vector<Cell> old(slots.size() * 2);
  old.swap(slots);
  const std::size_t mask = slots.size() - 1;
  for (const auto& cell : old) {
    if (cell.key == no_key) continue;
    std::size_t i = mix_bits(cell.key) & mask;
    while (slots[i].key != no_key) i = (i + 1) & mask;
    slots[i] = cell;
  }
}

void DistributionMap::insert(const Eigen::Vector3d& point, std::uint16_t line_bit) {
  for (auto& level : levels_) insert_into(level, point, line_bit);
}

void DistributionMap::insert_into(Level& level, const Eigen::Vector3d& point, std::uint16_t line_bit) {
  const Eigen::Vector3d in_cells = point / level.cell_m;
  Cell& cell = level.find_or_add(grid_key(in_cells));
  if (cell.count >= most_per_cell) return;
  const Eigen::Vector3d corner(std::floor(in_cells.x()), std::floor(in_cells.y()), std::floor(in_cells.z()));
  const Eigen::Vector3f d =
      ((in_cells - corner).array() - 0.5).matrix().cast<float>() * static_cast<float>(level.cell_m);
  ++cell.count;
  cell.lines |= line_bit;
  cell.sum += d;
  cell.second[0] += d.x() * d.x(), cell.second[1] += d.x() * d.y(), cell.second[2] += d.x() * d.z();
  cell.second[3] += d.y() * d.y(), cell.second[4] += d.y() * d.z(), cell.second[5] += d.z() * d.z();
}

void DistributionMap::Moments::add(const Cell& cell, const Eigen::Vector3d& centre) {
  const Eigen::Vector3d s = cell.sum.cast<double>();
  const double m = cell.count;
  const Eigen::Vector3d moved = s + m * centre;
  count += m;
  lines |= cell.lines;
  sum += moved;
  const float* q = cell.second;
  Eigen::Matrix3d own;
  own << q[0], q[1], q[2], q[1], q[3], q[4], q[2], q[4], q[5];
  second += own + s * centre.transpose() + centre * moved.transpose();
}

LocalSurface DistributionMap::Moments::surface(const Eigen::Vector3d& place, int level) const {
  LocalSurface surface;
  const Eigen::Vector3d mean = sum / count;
  const Eigen::Matrix3d covariance = second / count - mean * mean.transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(covariance);
  surface.mean = place + mean;
  surface.deviations_m = solver.eigenvalues().cwiseMax(1e-12).cwiseSqrt();
  surface.axes = solver.eigenvectors();
  surface.points = static_cast<int>(count);
  surface.lines = std::popcount(lines);
  surface.level = level;
  return surface;
}

// The 2 x 2 x 2 cells whose common corner is nearest to the point.
std::optional<LocalSurface> DistributionMap::surface(const Eigen::Vector3d& point, int level_index,
                                                     int least_points) const {
  const Level& level = levels_[static_cast<std::size_t>(level_index)];
  const double cell_m = level.cell_m;
  const auto cx = static_cast<std::int64_t>(std::lround(point.x() / cell_m)),
             cy = static_cast<std::int64_t>(std::lround(point.y() / cell_m)),
             cz = static_cast<std::int64_t>(std::lround(point.z() / cell_m));
  Moments moments;
  for (int k = 0; k < 8; ++k) {
    const int dx = (k & 1) - 1, dy = ((k >> 1) & 1) - 1, dz = (k >> 2) - 1;  // cell corner + 0 or - 1
    if (const Cell* cell = level.find(pack_cell(cx + dx, cy + dy, cz + dz)))
      moments.add(*cell, cell_m * Eigen::Vector3d(dx + 0.5, dy + 0.5, dz + 0.5));
  }
  if (moments.count < least_points) return std::nullopt;
  return moments.surface(
      cell_m * Eigen::Vector3d(static_cast<double>(cx), static_cast<double>(cy), static_cast<double>(cz)), level_index);
}

std::optional<LocalSurface> DistributionMap::cell_surface(const Eigen::Vector3d& point, int level_index,
                                                          int least_points) const {
  const Level& level = levels_[static_cast<std::size_t>(level_index)];
  const Eigen::Vector3d in_cells = point / level.cell_m;
  const Cell* cell = level.find(grid_key(in_cells));
  if (!cell || cell->count < least_points) return std::nullopt;
  Moments moments;
  moments.add(*cell, Eigen::Vector3d::Zero());
  return moments.surface((in_cells.array().floor() + 0.5).matrix() * level.cell_m, level_index);
}

}  // namespace bole
