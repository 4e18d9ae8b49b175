#include "render/scene/point_octree.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace bole::render {
namespace {

constexpr int bits = 16;          // of a cell index along one axis
constexpr int cell_levels = 6;    // 2^6 = cells_per_side
constexpr int bucket_levels = 4;  // of the Morton code, that points are first sorted by
constexpr int levels = bits - cell_levels + 1;
constexpr std::size_t small_node = 12'000;  // points
constexpr std::size_t buckets = std::size_t{1} << (3 * bucket_levels);
constexpr std::size_t poll_every = 0x100000;  // points between two looks at the cancel flag
constexpr std::size_t sample_nodes = 32;
static_assert(PointOctree::cells_per_side == 1 << cell_levels);

struct Cube {
  Eigen::Vector3f lo = Eigen::Vector3f::Zero();
  float side = 1;
};

// Every third bit of the result is one of the 16 of `v`.
std::uint64_t spread(std::uint64_t v) {
  v = (v | v << 32) & 0x1f00000000ffffULL;
  v = (v | v << 16) & 0x1f0000ff0000ffULL;
  v = (v | v << 8) & 0x100f00f00f00f00fULL;
  v = (v | v << 4) & 0x10c30c30c30c30c3ULL;
  return (v | v << 2) & 0x1249249249249249ULL;
}

std::uint64_t gather(std::uint64_t v) {
  v &= 0x1249249249249249ULL;
  v = (v | v >> 2) & 0x10c30c30c30c30c3ULL;
  v = (v | v >> 4) & 0x100f00f00f00f00fULL;
  v = (v | v >> 8) & 0x1f0000ff0000ffULL;
  v = (v | v >> 16) & 0x1f00000000ffffULL;
  return (v | v >> 32) & 0xffffULL;
}

std::uint64_t morton(const Eigen::Vector3f& p, const Cube& cube) {
  std::uint64_t code = 0;
  const float scale = static_cast<float>(1 << bits) / cube.side;
  for (int axis = 0; axis < 3; ++axis) {
    const float cell = std::clamp((p[axis] - cube.lo[axis]) * scale, 0.0f, static_cast<float>((1 << bits) - 1));
    code |= spread(static_cast<std::uint64_t>(cell)) << axis;
  }
  return code;
}

Cube cube_around(const PointCloud::Positions& positions) {
  constexpr float inf = std::numeric_limits<float>::infinity();
  Eigen::Vector3f lo(inf, inf, inf), hi(-inf, -inf, -inf);
  for (const auto& p : positions)
    if (p.allFinite()) lo = lo.cwiseMin(p), hi = hi.cwiseMax(p);
  if (!(lo.x() <= hi.x())) return {};
  return {lo, std::max((hi - lo).maxCoeff() * 1.0001f, 1e-3f)};
}

// How many levels of cells hold a point together with the one before it on the curve.
std::uint8_t shared_levels(std::uint64_t code, std::uint64_t before) {
  const std::uint64_t differ = code ^ before;
  return static_cast<std::uint8_t>(differ == 0 ? bits : bits - 1 - (63 - std::countl_zero(differ)) / 3);
}

// The level whose grid first tells a point from the one before it.
std::uint8_t level_of(std::uint8_t shared) {
  return static_cast<std::uint8_t>(std::clamp(shared + 1 - cell_levels, 0, levels - 1));
}

// A node whose points and those of all nodes below it are few takes them all: many small nodes are slow to draw.
void gather_small_nodes(const std::vector<std::uint8_t>& shared, std::vector<std::uint8_t>& level, const Run& run) {
  for (std::uint8_t l = 0; l + 1 < levels; ++l) {
    run.check_cancel();
    for (std::size_t begin = 0, end = 0; begin < shared.size(); begin = end) {
      std::size_t count = level[begin] >= l ? 1 : 0;
      for (end = begin + 1; end < shared.size() && shared[end] >= l; ++end) count += level[end] >= l ? 1 : 0;
      if (count <= small_node)
        for (std::size_t k = begin; k < end; ++k) level[k] = std::min(level[k], l);
    }
  }
}

struct Sorted {
  std::vector<std::uint32_t> index;  // along the curve
  std::vector<std::uint8_t> level;
};

Sorted along_the_curve(const PointCloud::Positions& positions, const Cube& cube, const Run& run) {
  constexpr int shift = 3 * (bits - bucket_levels);
  std::vector<std::uint32_t> begin(buckets + 1, 0);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (i % poll_every == 0) run.check_cancel();
    if (positions[i].allFinite()) ++begin[(morton(positions[i], cube) >> shift) + 1];
  }
  for (std::size_t b = 0; b < buckets; ++b) begin[b + 1] += begin[b];
  run.check_cancel();
  run.report(0.2, "sorting points for display");
  Sorted sorted{std::vector<std::uint32_t>(begin.back()), std::vector<std::uint8_t>(begin.back())};
  std::vector<std::uint8_t> shared(begin.back(), 0);
  auto next = begin;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (i % poll_every == 0) run.check_cancel();
    if (positions[i].allFinite())
      sorted.index[next[morton(positions[i], cube) >> shift]++] = static_cast<std::uint32_t>(i);
  }
  run.report(0.4, "sorting points for display");
  tbb::parallel_for(std::size_t{0}, buckets, [&](std::size_t b) {
    if (begin[b] == begin[b + 1] || run.cancelled()) return;
    std::vector<std::pair<std::uint64_t, std::uint32_t>> coded;
    for (auto k = begin[b]; k < begin[b + 1]; ++k)
      coded.emplace_back(morton(positions[sorted.index[k]], cube), sorted.index[k]);
    std::ranges::sort(coded);
    for (std::size_t k = 0; k < coded.size(); ++k) {
      sorted.index[begin[b] + k] = coded[k].second;
      if (k > 0) shared[begin[b] + k] = shared_levels(coded[k].first, coded[k - 1].first);
    }
  });
  run.check_cancel();
  // The first of each bucket follows the last of the one before; the very first shares nothing.
  for (std::size_t b = 0; b < buckets; ++b)
    if (const auto k = begin[b]; k != begin[b + 1] && k > 0)
      shared[k] = shared_levels(morton(positions[sorted.index[k]], cube), morton(positions[sorted.index[k - 1]], cube));
  std::ranges::transform(shared, sorted.level.begin(), level_of);
  gather_small_nodes(shared, sorted.level, run);
  return sorted;
}

struct Part {
  std::uint64_t prefix;  // of the Morton code: which node of the level
  std::uint32_t begin, end;
};
using Parts = std::vector<Part>;

// Adds nodes without points of their own where a child would have no parent.
void add_parents(Parts& parents, const Parts& children) {
  Parts missing;
  auto it = parents.begin();
  for (const auto& child : children) {
    const auto prefix = child.prefix >> 3;
    while (it != parents.end() && it->prefix < prefix) ++it;
    if ((it == parents.end() || it->prefix != prefix) && (missing.empty() || missing.back().prefix != prefix))
      missing.push_back({prefix, 0, 0});
  }
  Parts all(parents.size() + missing.size());
  std::ranges::merge(parents, missing, all.begin(), {}, &Part::prefix, &Part::prefix);
  parents = std::move(all);
}

PointOctree::Node node_of(const Part& part, int level, const Cube& cube) {
  PointOctree::Node node;
  const float side = cube.side / static_cast<float>(1 << level);
  node.half_m = side / 2;
  for (int axis = 0; axis < 3; ++axis)
    node.centre[axis] = cube.lo[axis] + side * (static_cast<float>(gather(part.prefix >> axis)) + 0.5f);
  node.begin = part.begin;
  node.end = part.end;
  node.level = static_cast<std::uint8_t>(level);
  return node;
}

std::vector<PointOctree::Node> linked_nodes(std::array<Parts, levels>& parts, const Cube& cube) {
  for (std::size_t l = levels - 1; l > 0; --l) add_parents(parts[l - 1], parts[l]);
  std::vector<PointOctree::Node> nodes;
  std::size_t first_of_next = 0;
  for (std::size_t l = 0; l < levels; ++l) {
    first_of_next += parts[l].size();
    std::size_t child = 0;
    for (const auto& part : parts[l]) {
      auto node = node_of(part, static_cast<int>(l), cube);
      node.first_child = static_cast<std::uint32_t>(first_of_next + child);
      while (l + 1 < levels && child < parts[l + 1].size() && parts[l + 1][child].prefix >> 3 == part.prefix) {
        ++child;
        ++node.children;
      }
      nodes.push_back(node);
    }
  }
  return nodes;
}

}  // namespace

double size_on_screen(const Eigen::Vector3f& middle, float half_m, const OctreeView& view) {
  const auto& m = view.world_to_clip;
  if ((middle.array() - half_m > view.hi.array()).any() || (middle.array() + half_m < view.lo.array()).any()) return -1;
  const Eigen::Vector4d centre(static_cast<double>(middle.x()), static_cast<double>(middle.y()),
                               static_cast<double>(middle.z()), 1);
  const double half = static_cast<double>(half_m);
  const auto outside = [&](const Eigen::RowVector4d& plane) {
    return plane.dot(centre) + half * plane.head<3>().cwiseAbs().sum() < 0;
  };
  for (int axis = 0; axis < 2; ++axis)
    if (outside(m.row(3) + m.row(axis)) || outside(m.row(3) - m.row(axis))) return -1;
  // The nearest place of its ball: the eye may be within.
  const double depth = m.row(3).dot(centre) - half * std::sqrt(3.0) * m.row(3).head<3>().norm();
  return 2 * half * m.row(1).head<3>().norm() * view.height_px / 2 / std::max(depth, 1e-3);
}

PointOctree::PointOctree(const PointCloud& cloud, const Run& run) : positions_(cloud.shared_positions()) {
  if (cloud.size() >= std::numeric_limits<std::uint32_t>::max())
    throw bad_input("a cloud of " + std::to_string(cloud.size()) + " points", "at most 4 294 967 294", "Thin it");
  const auto& positions = *positions_;
  const Cube cube = cube_around(positions);
  const auto sorted = along_the_curve(positions, cube, run);
  run.report(0.9, "sorting points for display");

  std::array<std::uint32_t, levels + 1> begin{};
  for (const auto level : sorted.level) ++begin[level + 1u];
  for (std::size_t l = 0; l < levels; ++l) begin[l + 1] += begin[l];
  order_.resize(sorted.index.size());
  std::array<Parts, levels> parts;
  auto next = begin;
  for (std::size_t k = 0; k < sorted.index.size(); ++k) {
    if (k % poll_every == 0) run.check_cancel();
    const auto level = sorted.level[k];
    const auto at = next[level]++;
    order_[at] = sorted.index[k];
    const auto prefix = morton(positions[sorted.index[k]], cube) >> (3 * (bits - level));
    if (parts[level].empty() || parts[level].back().prefix != prefix) parts[level].push_back({prefix, at, at});
    parts[level].back().end = at + 1;
  }
  run.check_cancel();
  nodes_ = linked_nodes(parts, cube);
}

PointOctree PointOctree::sample(const PointCloud& cloud, std::size_t points) {
  PointOctree tree;
  tree.positions_ = cloud.shared_positions();
  const auto& positions = *tree.positions_;
  if (positions.empty() || positions.size() >= std::numeric_limits<std::uint32_t>::max()) return tree;
  // One of every `step` points, at a place that wanders: points of a scan come in regular lines.
  const std::size_t step = std::max<std::size_t>(1, (positions.size() + points - 1) / std::max<std::size_t>(points, 1));
  const std::size_t strides = (positions.size() + step - 1) / step;
  constexpr float inf = std::numeric_limits<float>::infinity();
  Eigen::Vector3f lo(inf, inf, inf), hi(-inf, -inf, -inf);
  for (std::size_t share = 0; share < sample_nodes; ++share) {
    Node node;
    node.begin = static_cast<std::uint32_t>(tree.order_.size());
    for (std::size_t k = share; k < strides; k += sample_nodes) {
      const std::size_t i = std::min(k * step + (k * 2654435761U >> 8) % step, positions.size() - 1);
      if (!positions[i].allFinite()) continue;
      tree.order_.push_back(static_cast<std::uint32_t>(i));
      lo = lo.cwiseMin(positions[i]);
      hi = hi.cwiseMax(positions[i]);
    }
    node.end = static_cast<std::uint32_t>(tree.order_.size());
    if (node.size() == 0) continue;
    node.level = static_cast<std::uint8_t>(tree.nodes_.size());
    tree.nodes_.push_back(node);
  }
  for (std::size_t i = 0; i < tree.nodes_.size(); ++i) {
    auto& node = tree.nodes_[i];
    node.centre = (lo + hi) / 2;
    node.half_m = std::max((hi - lo).maxCoeff() / 2, 1e-3F);
    node.children = i + 1 < tree.nodes_.size() ? 1 : 0;
    node.first_child = static_cast<std::uint32_t>(i + 1);
  }
  return tree;
}

std::vector<std::uint32_t> PointOctree::visible(const OctreeView& view, std::size_t budget, double min_px) const {
  if (nodes_.empty()) return {};
  return largest_on_screen(
      view, budget, min_px,
      [&](std::uint32_t i) {
        const auto& node = nodes_[i];
        return NodeCube{node.centre, node.half_m, node.spacing_m(), node.size(), false};
      },
      [&](std::uint32_t i, auto&& consider) {
        for (std::uint32_t child = 0; child < nodes_[i].children; ++child) consider(nodes_[i].first_child + child);
      });
}

std::vector<std::uint32_t> PointOctree::in_box(const Eigen::Vector3f& lo, const Eigen::Vector3f& hi) const {
  std::vector<std::uint32_t> found, waiting;
  if (!nodes_.empty()) waiting.push_back(0);
  while (!waiting.empty()) {
    const auto& node = nodes_[waiting.back()];
    waiting.pop_back();
    if (((node.centre.array() - node.half_m) > hi.array()).any() ||
        ((node.centre.array() + node.half_m) < lo.array()).any())
      continue;
    for (const auto i : points(node))
      if (const auto& p = (*positions_)[i]; (p.array() >= lo.array()).all() && (p.array() <= hi.array()).all())
        found.push_back(i);
    for (std::uint32_t child = 0; child < node.children; ++child) waiting.push_back(node.first_child + child);
  }
  return found;
}

namespace {

class OctreeNodes : public PointNodes {
 public:
  OctreeNodes(std::shared_ptr<const PointCloud> cloud, std::shared_ptr<const PointOctree> octree)
      : cloud_(std::move(cloud)), octree_(std::move(octree)) {}

  Eigen::Vector3d origin() const override { return cloud_->origin; }
  std::vector<std::uint32_t> choose(const OctreeView& view, std::size_t budget, double min_px) override {
    return octree_->visible(view, budget, min_px);
  }
  std::size_t size_of(std::uint32_t node) const override { return octree_->nodes()[node].size(); }
  PointSet points(std::uint32_t node) const override {
    const auto indices = octree_->points(octree_->nodes()[node]);
    return {cloud_, {indices.begin(), indices.end()}};
  }
  std::shared_ptr<const PointCloud> cloud_of(std::uint32_t) const override { return cloud_; }

 private:
  std::shared_ptr<const PointCloud> cloud_;
  std::shared_ptr<const PointOctree> octree_;
};

}  // namespace

std::shared_ptr<PointNodes> nodes_in_memory(std::shared_ptr<const PointCloud> cloud,
                                            std::shared_ptr<const PointOctree> octree) {
  if (!cloud || !octree) return nullptr;
  return std::make_shared<OctreeNodes>(std::move(cloud), std::move(octree));
}

}  // namespace bole::render
