#include "stems/core/detect/slab_circles.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include "base/angles.h"

namespace bole::stems {
namespace {

// A small generator with a fixed sequence on every platform (splitmix64).
struct Random {
  // Of a place, by the voxel of the thinned layer that it lies in: what is tried there does not depend on what the
  // cloud holds elsewhere.
  static Random at(const StemLayer& grid, const Voxel& v, int slab) {
    const auto [ix, iy] = voxel_column(grid, v.x, v.y);
    return {(((static_cast<std::uint64_t>(iy) << 24) ^ static_cast<std::uint64_t>(ix)) << 8) +
            static_cast<std::uint64_t>(slab)};
  }

  std::uint64_t state;
  std::uint64_t next() {
    std::uint64_t z = (state += 0x9e3779b97f4a7c15ULL);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL, z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(next() % n); }
};

// Points on the ring count by their nearness to it, points well inside count against it.
struct Score {
  float on = 0, inside = 0, height = 0, z = 0, weight = 0;
  int points = 0;
  float most() const { return on - 1.5F * inside; }  // what a whole circle would score
  std::uint32_t sectors = 0;                         // bit per 20 degrees
};

constexpr int sector_count = 18;

// Which sector around a circle's centre a difference lies in, counted from the negative x axis. Angles are not needed:
// what replaces them grows with them by four a turn, and a step of the table holds no more than one limit of a sector.
class SectorTable {
 public:
  SectorTable() {
    std::size_t sector = 0;
    for (std::size_t k = 0; k < steps; ++k) {
      first_[k] = static_cast<std::uint8_t>(sector), limit_[k] = 5;
      const double next = 2 * std::numbers::pi * static_cast<double>(sector + 1) / sector_count - std::numbers::pi;
      const auto turned = turned_by(static_cast<float>(std::cos(next)), static_cast<float>(std::sin(next)));
      if (sector + 1 < sector_count && turned < static_cast<float>(k + 1) / by_step) limit_[k] = turned, ++sector;
    }
  }
  unsigned operator()(float dx, float dy) const {
    const float turned = turned_by(dx, dy);
    const auto k = std::min(steps - 1, static_cast<std::size_t>(turned * by_step));
    return first_[k] + static_cast<unsigned>(turned >= limit_[k]);
  }

 private:
  static constexpr std::size_t steps = 64;
  static constexpr float by_step = steps / 4.F;
  static float turned_by(float dx, float dy) {
    const float share = dx / std::max(1e-30F, std::abs(dx) + std::abs(dy));
    return dy < 0 ? 1 + share : 3 - share;
  }
  std::array<std::uint8_t, steps> first_{};
  std::array<float, steps> limit_{};
};

float ring_tolerance(float radius) { return std::clamp(0.12F * radius, 0.018F, 0.04F); }

// The voxels of one slab, projected to the ground: one per column, by cell of the layer's grid.
class SlabGrid {
 public:
  SlabGrid(const StemLayer& grid, const VoxelLayer& thin, float low, float high) : grid_(grid) {
    start_.reserve(thin.start.size()), start_.push_back(0);
    for (std::size_t cell = 0; cell + 1 < thin.start.size(); ++cell) {
      add_columns(thin, thin.start[cell], thin.start[cell + 1], low, high);
      start_.push_back(static_cast<std::uint32_t>(columns_.size()));
    }
    x_.reserve(columns_.size()), y_.reserve(columns_.size()), weight_.reserve(columns_.size());
    for (const auto& c : columns_) x_.push_back(c.x), y_.push_back(c.y), weight_.push_back(c.weight);
  }

  std::pair<std::uint32_t, std::uint32_t> cell(int ix, int iy) const {
    const auto c = static_cast<std::size_t>(iy) * static_cast<std::size_t>(grid_.nx) + static_cast<std::size_t>(ix);
    return {start_[c], start_[c + 1]};
  }
  const Voxel& operator[](std::uint32_t k) const { return columns_[k]; }
  std::uint32_t size() const { return static_cast<std::uint32_t>(columns_.size()); }

  // Calls f(first, last) for the stretches of columns whose cells meet the square of half-width `reach` around (x, y).
  template <class F>
  void for_each_stretch_near(float x, float y, float reach, F&& f) const {
    const int x0 = grid_.cell_x(x - reach), x1 = grid_.cell_x(x + reach), y0 = grid_.cell_y(y - reach),
              y1 = grid_.cell_y(y + reach);
    for (int iy = y0; iy <= y1; ++iy) {
      const auto row = static_cast<std::size_t>(iy) * static_cast<std::size_t>(grid_.nx);
      const auto first = start_[row + static_cast<std::size_t>(x0)],
                 last = start_[row + static_cast<std::size_t>(x1) + 1];
      if (first < last) f(first, last);
    }
  }
  template <class F>
  void for_each_near(float x, float y, float reach, F&& f) const {
    for_each_stretch_near(x, y, reach, [&](std::uint32_t first, std::uint32_t last) {
      for (auto k = first; k < last; ++k) f(k);
    });
  }

  // By column, for sums over many of them.
  const float* x() const { return x_.data(); }
  const float* y() const { return y_.data(); }
  const float* weight() const { return weight_.data(); }

 private:
  // Voxels of a cell are sorted by height, then y, then x: columns of a slab are joined through their key.
  void add_columns(const VoxelLayer& thin, std::uint32_t first, std::uint32_t last, float low, float high) {
    struct Keyed {
      std::int64_t key;
      std::uint32_t k;
    };
    std::vector<Keyed> keyed;
    for (auto k = first; k < last; ++k) {
      const auto& v = thin.voxels[k];
      if (v.height < low || v.height >= high) continue;
      const auto [ix, iy] = voxel_column(grid_, v.x, v.y);
      keyed.push_back({iy * (std::int64_t{1} << 32) + ix, k});
    }
    std::ranges::stable_sort(keyed, {}, &Keyed::key);
    for (std::size_t i = 0; i < keyed.size();) {
      Voxel sum;
      std::size_t j = i;
      for (; j < keyed.size() && keyed[j].key == keyed[i].key; ++j) {
        const auto& v = thin.voxels[keyed[j].k];
        const float w = v.weight * v.weight;
        sum.x += w * v.x, sum.y += w * v.y, sum.z += w * v.z, sum.height += w * v.height, sum.weight += w;
      }
      columns_.push_back(
          {sum.x / sum.weight, sum.y / sum.weight, sum.z / sum.weight, sum.height / sum.weight, std::sqrt(sum.weight)});
      i = j;
    }
  }

  const StemLayer& grid_;
  std::vector<Voxel> columns_;
  std::vector<float> x_, y_, weight_;
  std::vector<std::uint32_t> start_;
};

struct Ring {
  Ring(float centre_x, float centre_y, float r)
      : x(centre_x),
        y(centre_y),
        radius(r),
        tolerance(ring_tolerance(r)),
        outer(radius + tolerance),
        hollow(std::max(0.F, radius - 2.5F * tolerance)) {}
  float x, y, radius, tolerance, outer, hollow;
};

// Nearly all circles are worse than the best so far. Sums over several columns at a time tell most of them, but for
// rounding, which depends on the order of the sums and is allowed for.
bool can_beat(const SlabGrid& slab, const Ring& ring, double beat) {
  constexpr float rounding = 1e-4F;
  constexpr float steep = 1e12F;  // times a difference and held between 0 and 1: whether it is positive
  const float by_tolerance = 1 / ring.tolerance, hollow2 = ring.hollow * ring.hollow;
  Score all;
  slab.for_each_stretch_near(ring.x, ring.y, ring.outer, [&](std::uint32_t first, std::uint32_t last) {
    using Values = Eigen::Map<const Eigen::ArrayXf>;
    const auto n = static_cast<Eigen::Index>(last - first);
    const Values x(slab.x() + first, n), y(slab.y() + first, n), weight(slab.weight() + first, n);
    const auto d2 = (x - ring.x).square() + (y - ring.y).square();
    all.on += (weight * (1 - ((d2.sqrt() - ring.radius) * by_tolerance).square()).max(0.F)).sum();
    if (hollow2 > 0) all.inside += (weight * ((hollow2 - d2) * steep).max(0.F).min(1.F)).sum();
  });
  return all.most() + rounding * (all.on + all.inside) > beat;
}

// Sectors are counted only where the circle could beat `beat`: most cannot, and angles are what costs.
Score score_circle(const SlabGrid& slab, const Ring& ring, double beat) {
  Score s;
  slab.for_each_near(ring.x, ring.y, ring.outer, [&](std::uint32_t k) {
    const auto& v = slab[k];
    const float dx = v.x - ring.x, dy = v.y - ring.y, d2 = dx * dx + dy * dy;
    if (d2 > ring.outer * ring.outer) return;
    const float e = (std::sqrt(d2) - ring.radius) / ring.tolerance;
    if (e > -1) {
      s.on += v.weight * (1 - e * e), s.height += v.weight * v.height, s.z += v.weight * v.z, s.weight += v.weight,
          ++s.points;
    } else if (d2 < ring.hollow * ring.hollow) {
      s.inside += v.weight;
    }
  });
  if (s.most() <= beat) return s;
  static const SectorTable sector_of;
  const float inner = ring.radius - ring.tolerance;
  slab.for_each_near(ring.x, ring.y, ring.outer, [&](std::uint32_t k) {
    const float dx = slab[k].x - ring.x, dy = slab[k].y - ring.y, d2 = dx * dx + dy * dy;
    if (d2 > ring.outer * ring.outer || (inner > 0 && d2 <= inner * inner)) return;
    s.sectors |= 1U << sector_of(dx, dy);
  });
  return s;
}

bool circle_through(const Voxel& a, const Voxel& b, const Voxel& c, float& x, float& y, float& radius) {
  const float bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y, cross = 2 * (bx * cy - by * cx);
  const float b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
  if (std::abs(cross) < 1e-6F + 0.02F * std::sqrt(b2 * c2)) return false;
  const float ux = (cy * b2 - by * c2) / cross, uy = (bx * c2 - cx * b2) / cross;
  radius = std::sqrt(ux * ux + uy * uy), x = a.x + ux, y = a.y + uy;
  return true;
}

constexpr std::array<float, 4> reaches{0.08F, 0.2F, 0.45F, 1.0F};
constexpr std::uint32_t max_seeds = 6;  // per cell
constexpr double usual_radius_m = 0.12;

// Tries per seed and reach. Few points cost little, and there each must do.
int attempts_among(std::size_t points) { return points < 150 ? 25 : 5; }

// Columns around a cell, as stretches of them.
class Neighbours {
 public:
  Neighbours(const SlabGrid& slab, float x, float y, float reach) {
    slab.for_each_stretch_near(x, y, reach, [&](std::uint32_t first, std::uint32_t last) {
      stretches_.push_back({size_, first}), size_ += last - first;
    });
  }
  std::size_t size() const { return size_; }
  std::uint32_t operator[](std::size_t i) const {
    const auto it = std::prev(std::ranges::upper_bound(stretches_, i, {}, &Stretch::before));
    return it->first + static_cast<std::uint32_t>(i - it->before);
  }

 private:
  struct Stretch {
    std::size_t before;
    std::uint32_t first;
  };
  std::vector<Stretch> stretches_;
  std::size_t size_ = 0;
};

// The best circle through `seed` and two of its neighbours, tried at several scales.
SlabCircle best_circle_at(const SlabGrid& slab, const std::vector<Neighbours>& near, const Voxel& seed,
                          const MeasureOptions& options, Random random) {
  const auto least = static_cast<float>(0.0035 * options.min_dbh_cm),
             most = static_cast<float>(0.0055 * options.max_dbh_cm);  // radii with a margin
  SlabCircle best;
  for (std::size_t scale = 0; scale < reaches.size() && reaches[scale] <= 4 * most; ++scale) {
    const auto& local = near[scale];
    if (local.size() < 5) continue;
    for (int attempt = 0; attempt < attempts_among(local.size()); ++attempt) {
      float x = 0, y = 0, radius = 0;
      if (!circle_through(seed, slab[local[random.below(local.size())]], slab[local[random.below(local.size())]], x, y,
                          radius))
        continue;
      if (radius < least || radius > std::min(most, reaches[scale])) continue;
      // Wide circles meet more leaves by chance: what counts is between the number of points and their density.
      const double share = std::sqrt(usual_radius_m / radius);
      const Ring ring(x, y, radius);
      if (!can_beat(slab, ring, best.score / share)) continue;
      const auto s = score_circle(slab, ring, best.score / share);
      if (share * s.most() <= best.score) continue;
      const double arc = static_cast<double>(std::popcount(s.sectors)) / sector_count;
      const double score = share * s.most() * std::sqrt(arc);
      if (score <= best.score || s.points < 5) continue;
      best.x = x, best.y = y, best.radius = radius, best.score = score, best.arc_rad = arc * 2 * std::numbers::pi,
      best.points = s.points;
      best.height = s.height / s.weight, best.z = s.z / s.weight;
    }
  }
  return best;
}

std::vector<SlabCircle> seek_in_row(const StemLayer& grid, const SlabGrid& slab, int number, int iy,
                                    const MeasureOptions& options) {
  std::vector<SlabCircle> found;
  std::vector<Neighbours> near;  // by reach
  for (int ix = 0; ix < grid.nx; ++ix) {
    const auto [first, last] = slab.cell(ix, iy);
    if (first == last) continue;
    const auto x = static_cast<float>(grid.corner.x() + (ix + 0.5) * grid.cell_m),
               y = static_cast<float>(grid.corner.y() + (iy + 0.5) * grid.cell_m);
    near.clear();
    for (const float reach : reaches) near.emplace_back(slab, x, y, reach);
    const auto stride = (last - first + max_seeds - 1) / max_seeds;
    for (auto k = first; k < last; k += stride) {
      auto circle = best_circle_at(slab, near, slab[k], options, Random::at(grid, slab[k], number));
      if (circle.score <= 0 || circle.arc_rad < radians(options.min_arc_deg)) continue;
      circle.slab = number;
      found.push_back(circle);
    }
  }
  return found;
}

// A weaker circle goes when it overlaps a stronger one by more than two bark-touching stems would.
std::vector<SlabCircle> suppress_overlaps(std::vector<SlabCircle> circles, const MeasureOptions& options,
                                          const StemLayer& grid) {
  std::ranges::stable_sort(circles, std::ranges::greater{}, &SlabCircle::score);
  std::vector<SlabCircle> kept;
  const double cell = 0.01 * options.max_dbh_cm + 0.1;
  const int nx = static_cast<int>(grid.nx * grid.cell_m / cell) + 3;
  const int ny = static_cast<int>(grid.ny * grid.cell_m / cell) + 3;
  std::vector<std::vector<std::uint32_t>> by_cell(static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny));
  const auto cell_of = [&](double v, double corner, int n) {
    return std::clamp(static_cast<int>(std::floor((v - corner) / cell)) + 1, 0, n - 1);
  };
  for (const auto& c : circles) {
    const int ix = cell_of(c.x, grid.corner.x(), nx), iy = cell_of(c.y, grid.corner.y(), ny);
    bool free = true;
    for (int jy = std::max(0, iy - 1); free && jy <= std::min(ny - 1, iy + 1); ++jy)
      for (int jx = std::max(0, ix - 1); free && jx <= std::min(nx - 1, ix + 1); ++jx)
        for (const auto k :
             by_cell[static_cast<std::size_t>(jy) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(jx)]) {
          const auto& o = kept[k];
          if (std::hypot(o.x - c.x, o.y - c.y) < o.radius + c.radius - 0.4 * std::min(o.radius, c.radius)) free = false;
        }
    if (!free) continue;
    by_cell[static_cast<std::size_t>(iy) * static_cast<std::size_t>(nx) + static_cast<std::size_t>(ix)].push_back(
        static_cast<std::uint32_t>(kept.size()));
    kept.push_back(c);
  }
  return kept;
}

int slab_count(const MeasureOptions& options) {
  return std::max(1, static_cast<int>(std::round((options.search_top - options.search_bottom) / slab_thickness_m)));
}

float slab_edge(const MeasureOptions& options, int slab) {
  return static_cast<float>(options.search_bottom + slab * slab_thickness_m);
}

}  // namespace

double slabs_top_m(const MeasureOptions& options) { return slab_edge(options, slab_count(options)); }

std::vector<SlabCircle> find_slab_circles(const StemLayer& grid, const VoxelLayer& thin, const MeasureOptions& options,
                                          const Run& run) {
  std::vector<SlabCircle> all;
  const int slabs = slab_count(options);
  for (int s = 0; s < slabs; ++s) {
    run.report(static_cast<double>(s) / slabs, "circles by height");
    const SlabGrid slab(grid, thin, slab_edge(options, s), slab_edge(options, s + 1));
    std::vector<std::vector<SlabCircle>> by_row(static_cast<std::size_t>(grid.ny));
    for_each_row(grid, run,
                 [&](int iy) { by_row[static_cast<std::size_t>(iy)] = seek_in_row(grid, slab, s, iy, options); });
    std::vector<SlabCircle> found;
    for (auto& row : by_row) found.insert(found.end(), row.begin(), row.end());
    found = suppress_overlaps(std::move(found), options, grid);
    all.insert(all.end(), found.begin(), found.end());
  }
  return all;
}

}  // namespace bole::stems
