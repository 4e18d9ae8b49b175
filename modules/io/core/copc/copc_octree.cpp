#include "io/core/copc/copc_octree.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <numeric>

#include "base/error.h"

namespace bole::io::copc {

namespace {

constexpr unsigned grid_bits = OctreeRoot::grid_bits, place_bits = OctreeRoot::place_bits;
constexpr int max_level = 20;  // its cells take 27 bits of a place
constexpr std::size_t block = 1 << 14;

struct StepBox {
  std::array<std::int32_t, 3> min, max;
  StepBox() {
    min.fill(std::numeric_limits<std::int32_t>::max());
    max.fill(std::numeric_limits<std::int32_t>::min());
  }
  void add(const std::array<std::int32_t, 3>& at) {
    for (std::size_t k = 0; k < 3; ++k) {
      min[k] = std::min(min[k], at[k]);
      max[k] = std::max(max[k], at[k]);
    }
  }
};

// A node while the tree grows.
struct Branch {
  int level = 0;
  Eigen::Vector3i key = Eigen::Vector3i::Zero();
  std::size_t first = 0, count = 0;
  std::array<std::unique_ptr<Branch>, 8> children;
};

class OctreeBuilder {
 public:
  OctreeBuilder(const OctreePoints& points, const OctreeOptions& options, const Run& run)
      : points_(points),
        options_(options),
        run_(run),
        order_(points.count),
        scratch_(points.count),
        bucket_(points.count) {
    std::iota(order_.begin(), order_.end(), 0U);
    root_ = options.root ? *options.root : cube_around_points();
    if (!order_.empty()) deepest_ = root_.deepest(points.grid.scale.maxCoeff());
  }

  Octree build() {
    Branch root;
    root.level = root_.level;
    root.key = root_.key;
    divide(root, 0, order_.size());
    run_.check_cancel();
    Octree out;
    out.order = std::move(order_);
    out.half_size = root_.side / 2;
    out.centre = root_.centre();
    out.spacing = root_.spacing();
    std::vector<const Branch*> level{&root}, next;
    for (; !level.empty(); level.swap(next)) {
      next.clear();
      for (const Branch* branch : level) {
        if (branch->count > 0)
          out.nodes.push_back({branch->level, branch->key, {branch->first, branch->count, out.order.data()}});
        for (const auto& child : branch->children)
          if (child) next.push_back(child.get());
      }
    }
    return out;
  }

 private:
  OctreeRoot cube_around_points() {
    const auto box = tbb::parallel_deterministic_reduce(
        tbb::blocked_range<std::size_t>(0, order_.size(), block), StepBox(),
        [&](const tbb::blocked_range<std::size_t>& range, StepBox sum) {
          for (std::size_t i = range.begin(); i < range.end() && !run_.cancelled(); ++i) sum.add(points_.steps(i));
          return sum;
        },
        [](StepBox a, const StepBox& b) {
          a.add(b.min);
          a.add(b.max);
          return a;
        });
    run_.check_cancel();
    return order_.empty() ? OctreeRoot() : root_around(points_.grid, box.min, box.max);
  }

  // The cell within a node of the level (three times grid_bits bits) below the octant (three bits).
  std::uint32_t cell_of(std::uint32_t point, int level) const {
    const auto places = root_.place(points_.grid, points_.steps(point));
    std::uint32_t cell = 0, octant = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const unsigned cell_shift = place_bits - static_cast<unsigned>(level) - grid_bits;
      cell |= (places[k] >> cell_shift & ((1U << grid_bits) - 1)) << (grid_bits * k);
      octant |= (places[k] >> (place_bits - static_cast<unsigned>(level) - 1) & 1U) << k;
    }
    return octant << (3 * grid_bits) | cell;
  }

  void divide(Branch& branch, std::size_t first, std::size_t count) {
    branch.first = first;
    branch.count = count;
    if (run_.cancelled() || count <= options_.node_points || branch.level >= deepest_) return;
    const auto sizes = sort_into_buckets(branch.level, first, count);
    branch.count = sizes[0];
    std::array<std::size_t, 8> begin{};
    std::size_t at = first + sizes[0];
    for (int octant = 0; octant < 8; ++octant) {
      begin[octant] = at;
      at += sizes[octant + 1];
      if (sizes[octant + 1] == 0) continue;
      auto child = std::make_unique<Branch>();
      child->level = branch.level + 1;
      child->key = 2 * branch.key + Eigen::Vector3i(octant & 1, octant >> 1 & 1, octant >> 2);
      branch.children[octant] = std::move(child);
    }
    tbb::parallel_for(0U, 8U, [&](unsigned octant) {
      if (branch.children[octant]) divide(*branch.children[octant], begin[octant], sizes[octant + 1]);
    });
  }

  // Bucket 0 holds the points that the node keeps, 1 to 8 those of the octants; each in the order of the cloud.
  std::array<std::size_t, 9> sort_into_buckets(int level, std::size_t first, std::size_t count) {
    std::uint32_t* const points = order_.data() + first;
    std::uint32_t* const cells = scratch_.data() + first;
    std::uint8_t* const buckets = bucket_.data() + first;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, block),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                        for (std::size_t i = range.begin(); i < range.end(); ++i) cells[i] = cell_of(points[i], level);
                      });
    std::array<std::size_t, 9> sizes{};
    mark_kept(cells, buckets, count, sizes);
    absorb_small(buckets, count, sizes);
    std::array<std::size_t, 9> at{};
    std::partial_sum(sizes.begin(), sizes.end() - 1, at.begin() + 1);
    for (std::size_t i = 0; i < count; ++i) cells[at[buckets[i]]++] = points[i];  // the cells are not needed any more
    std::copy_n(cells, count, points);
    return sizes;
  }

  static void mark_kept(const std::uint32_t* cells, std::uint8_t* buckets, std::size_t count,
                        std::array<std::size_t, 9>& sizes) {
    constexpr std::uint32_t cell_mask = (1U << (3 * grid_bits)) - 1;
    std::vector<bool> taken(std::size_t{1} << (3 * grid_bits));
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t cell = cells[i] & cell_mask;
      buckets[i] = taken[cell] ? static_cast<std::uint8_t>(1 + (cells[i] >> (3 * grid_bits))) : std::uint8_t{0};
      taken[cell] = true;
      ++sizes[buckets[i]];
    }
  }

  void absorb_small(std::uint8_t* buckets, std::size_t count, std::array<std::size_t, 9>& sizes) const {
    std::array<std::uint8_t, 9> becomes{};
    bool any = false;
    for (std::uint8_t b = 1; b < 9; ++b) {
      const bool small = sizes[b] > 0 && sizes[b] < options_.min_points;
      becomes[b] = small ? std::uint8_t{0} : b;
      if (!small) continue;
      any = true;
      sizes[0] += sizes[b];
      sizes[b] = 0;
    }
    if (!any) return;
    for (std::size_t i = 0; i < count; ++i) buckets[i] = becomes[buckets[i]];
  }

  const OctreePoints& points_;
  OctreeOptions options_;
  const Run& run_;
  std::vector<std::uint32_t> order_, scratch_;
  std::vector<std::uint8_t> bucket_;
  OctreeRoot root_;
  int deepest_ = 0;
};

}  // namespace

double OctreeRoot::spacing() const { return side / (1 << grid_bits); }

int OctreeRoot::deepest(double step) const {
  int level_of_steps = 0;
  while (level_of_steps < max_level && spacing() > step * static_cast<double>(std::int64_t{1} << level_of_steps))
    ++level_of_steps;
  return level_of_steps;
}

OctreeRoot root_around(const las::Grid& grid, const std::array<std::int32_t, 3>& low,
                       const std::array<std::int32_t, 3>& high) {
  Eigen::Vector3d lo, hi;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const auto axis = static_cast<std::size_t>(k);
    lo[k] = grid.offset[k] + grid.scale[k] * low[axis];
    hi[k] = grid.offset[k] + grid.scale[k] * high[axis];
  }
  OctreeRoot root;
  // None shall lie on its upper faces.
  root.side = (hi - lo).maxCoeff() + 2 * grid.scale.maxCoeff();
  root.low = (lo + hi) / 2 - Eigen::Vector3d::Constant(root.side / 2);
  return root;
}

Octree build_octree(const OctreePoints& points, const Run& run, const OctreeOptions& options) {
  if (points.count > std::numeric_limits<std::uint32_t>::max())
    throw bad_input(fmt::format("{} points", points.count), "at most 4294967295 for COPC", "Write LAZ, or tiles");
  return OctreeBuilder(points, options, run).build();
}

}  // namespace bole::io::copc
