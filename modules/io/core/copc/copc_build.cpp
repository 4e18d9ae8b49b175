#include "io/core/copc/copc_build.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "base/error.h"
#include "io/core/copc/copc_bins.h"
#include "io/core/copc/copc_node_file.h"

namespace bole::io::copc {
namespace {

namespace fs = std::filesystem;

constexpr int max_bin_level = 6;
constexpr std::size_t bytes_per_order = 9;  // of a point, of the octree that is built
constexpr std::uint64_t bins_wanted_per_memory = 4;

std::array<std::int32_t, 3> steps_at(const std::uint8_t* record) {
  return {las::load<std::int32_t>(record), las::load<std::int32_t>(record + 4), las::load<std::int32_t>(record + 8)};
}

// A node whose points are not in the file yet: the one above takes its share first.
struct OpenNode {
  int level = 0;
  Cube key{};
  std::vector<std::uint8_t> records;
  bool has_children = false;
};

Eigen::Vector3i key_of_cube(const Cube& cube) { return {cube[0], cube[1], cube[2]}; }

// A folder that goes when the work is done or given up.
class ScratchFolder {
 public:
  explicit ScratchFolder(const fs::path& within) : path_(within) {
    for (int k = 0; !fs::create_directories(path_ = within / fmt::format("bole_octree_{}", k)); ++k)
      if (k > 10'000)
        throw failure(fmt::format("no folder can be made in '{}'", within.string()), "a folder to write to");
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

class Builder {
 public:
  Builder(const RecordStream& stream, const fs::path& scratch, const BuildOptions& options, const Run& run)
      : stream_(stream), options_(options), run_(run), stride_(stream.form.record_length), scratch_(scratch) {
    max_in_memory_ = std::max<std::size_t>(options.memory_bytes / (2 * stride_ + bytes_per_order), 1000);
    while (bin_level_ < max_bin_level && (max_in_memory_ / bins_wanted_per_memory) << (2 * bin_level_) < stream.points)
      ++bin_level_;
    if (stream.points <= max_in_memory_) bin_level_ = 0;
  }

  BuiltFile build(const fs::path& path) {
    root_ = root_around(stream_.form.grid, stream_.low, stream_.high);
    if (stream_.within)
      sorted_ = stream_.points;
    else
      sort_into_bins();
    file_.emplace(path, stream_, root_);
    const auto root = branch(0, {0, 0, 0});
    if (root.records.empty()) throw bad_input("the file holds no points", "a cloud");
    file_->write({{root.level, key_of_cube(root.key), root.records}});
    return file_->finish();
  }

 private:
  Cube cube_at(int level, const std::uint8_t* record) const {
    const auto place = root_.place(stream_.form.grid, steps_at(record));
    const unsigned shift = OctreeRoot::place_bits - static_cast<unsigned>(level);
    return {static_cast<int>(place[0] >> shift), static_cast<int>(place[1] >> shift),
            static_cast<int>(place[2] >> shift)};
  }

  void sort_into_bins() {
    if (!sort(run_.part(0, 0.4))) {  // the box was too small: now it is known
      root_ = root_around(stream_.form.grid, box_.min, box_.max);
      sort(run_.part(0, 0.4));
    }
    for (const auto& cube : bins_->cubes())
      for (int level = bin_level_; level >= 0; --level) {
        const int up = bin_level_ - level;
        occupied_.insert({level, cube[0] >> up, cube[1] >> up, cube[2] >> up});
      }
  }

  // The box of a cube in steps, a step wider than it is.
  std::array<std::array<std::int32_t, 3>, 2> steps_of(int level, const Cube& key) const {
    const auto& grid = stream_.form.grid;
    const double side = std::ldexp(root_.side, -level);
    std::array<std::array<std::int32_t, 3>, 2> box{};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      const double low = (root_.low[axis] + side * key[k] - grid.offset[axis]) / grid.scale[axis];
      box[0][k] = static_cast<std::int32_t>(std::floor(low)) - 1;
      box[1][k] = static_cast<std::int32_t>(std::ceil(low + side / grid.scale[axis])) + 1;
    }
    return box;
  }

  bool may_hold_points(int level, const Cube& key) const {
    if (!stream_.within) return occupied_.contains({level, key[0], key[1], key[2]});
    const auto [low, high] = steps_of(level, key);
    for (std::size_t k = 0; k < 3; ++k)
      if (high[k] < stream_.low[k] || low[k] > stream_.high[k]) return false;
    return true;
  }

  std::vector<std::uint8_t> records_within(int level, const Cube& key) const {
    const auto [low, high] = steps_of(level, key);
    auto records = stream_.within(low, high);
    std::size_t kept = 0;
    for (std::size_t at = 0; at < records.size(); at += stride_) {
      if (cube_at(level, &records[at]) != key) continue;
      std::copy_n(&records[at], stride_, &records[kept]);
      kept += stride_;
    }
    records.resize(kept);
    return records;
  }

  // False: points lie beyond the box that was announced.
  bool sort(const Run& run) {
    bins_.emplace(scratch_.path(), "b", stride_, options_.memory_bytes);
    sorted_ = 0;
    std::uint64_t outside = 0;
    const auto low = stream_.low, high = stream_.high;
    const bool first_time = box_.points == 0;
    stream_.for_each(run, [&](const std::uint8_t* records, std::size_t count) {
      run.check_cancel();
      for (std::size_t i = 0; i < count; ++i, records += stride_) {
        const auto at = steps_at(records);
        bool within = true;
        for (std::size_t k = 0; k < 3; ++k) {
          within = within && (!first_time || (at[k] >= low[k] && at[k] <= high[k]));
          if (!first_time) continue;
          box_.min[k] = std::min(box_.min[k], at[k]);
          box_.max[k] = std::max(box_.max[k], at[k]);
        }
        if (within && outside == 0) bins_->put(cube_at(bin_level_, records), records);
        if (!within) ++outside;
      }
      sorted_ += count;
    });
    box_.points = sorted_;
    return outside == 0;
  }

  OpenNode branch(int level, const Cube& key) {
    run_.check_cancel();
    if (level == bin_level_ && stream_.within) return in_memory(level, key, records_within(level, key));
    if (level == bin_level_) {
      if (bins_->count(key) <= max_in_memory_ || level >= deepest()) return in_memory(level, key, bins_->take_all(key));
      return divided(level, key, *bins_);
    }
    std::vector<OpenNode> children;
    for (int octant = 0; octant < 8; ++octant) {
      const Cube child = child_of(key, octant);
      if (may_hold_points(level + 1, child)) children.push_back(branch(level + 1, child));
    }
    return joined(level, key, std::move(children));
  }

  // A cube with more points than fit into memory.
  OpenNode divided(int level, const Cube& key, RecordBins& bins) {
    RecordBins parts(scratch_.path(), fmt::format("d{}", level + 1), stride_, options_.memory_bytes);
    bins.for_each(key, [&](const std::uint8_t* records, std::size_t count) {
      run_.check_cancel();
      for (std::size_t i = 0; i < count; ++i, records += stride_) parts.put(cube_at(level + 1, records), records);
    });
    bins.forget(key);
    std::vector<OpenNode> children;
    for (const auto& cube : parts.cubes())
      children.push_back(parts.count(cube) <= max_in_memory_ || level + 1 >= deepest()
                             ? in_memory(level + 1, cube, parts.take_all(cube))
                             : divided(level + 1, cube, parts));
    return joined(level, key, std::move(children));
  }

  int deepest() const { return root_.deepest(stream_.form.grid.scale.maxCoeff()); }
  static Cube child_of(const Cube& key, int octant) {
    return {2 * key[0] + (octant & 1), 2 * key[1] + (octant >> 1 & 1), 2 * key[2] + (octant >> 2)};
  }

  OpenNode in_memory(int level, const Cube& key, std::vector<std::uint8_t> records) {
    if (records.empty()) return {level, key, {}, false};
    OctreeOptions octree_options = options_.octree;
    octree_options.root = root_;
    octree_options.root->level = level;
    octree_options.root->key = key_of_cube(key);
    const OctreePoints points{records.size() / stride_, stream_.form.grid,
                              [&](std::size_t i) { return steps_at(&records[i * stride_]); }};
    const auto octree = build_octree(points, run_, octree_options);
    OpenNode top{level, key, gathered(records, octree.nodes.front().points), octree.nodes.size() > 1};
    constexpr std::size_t at_once = 16;
    for (std::size_t begin = 1; begin < octree.nodes.size(); begin += at_once) {
      run_.check_cancel();
      std::vector<std::vector<std::uint8_t>> own;
      std::vector<NodeFile::Node> nodes;
      for (std::size_t i = begin; i < std::min(begin + at_once, octree.nodes.size()); ++i) {
        const auto& n = octree.nodes[i];
        own.push_back(gathered(records, n.points));
        nodes.push_back({n.level, n.key, {}});
      }
      for (std::size_t i = 0; i < own.size(); ++i) nodes[i].records = own[i];
      file_->write(nodes);
    }
    done_ += records.size() / stride_;
    run_.report(0.4 + 0.6 * static_cast<double>(done_) / static_cast<double>(sorted_), "building the octree");
    return top;
  }

  std::vector<std::uint8_t> gathered(const std::vector<std::uint8_t>& records, const las::PointList& points) const {
    std::vector<std::uint8_t> out(points.count * stride_);
    for (std::size_t i = 0; i < points.count; ++i)
      std::copy_n(&records[points[i] * stride_], stride_, &out[i * stride_]);
    return out;
  }

  // The node above its children: it takes all of their points where they are few, else one of each cell.
  OpenNode joined(int level, const Cube& key, std::vector<OpenNode> children) {
    OpenNode node{level, key, {}, false};
    std::size_t all = 0;
    for (const auto& child : children) {
      all += child.records.size() / stride_;
      node.has_children = node.has_children || child.has_children;
    }
    node.has_children = node.has_children || all > options_.octree.node_points;
    if (!node.has_children) {
      for (const auto& child : children)
        node.records.insert(node.records.end(), child.records.begin(), child.records.end());
      return node;
    }
    std::vector<bool> taken(std::size_t{1} << (3 * OctreeRoot::grid_bits));
    for (auto& child : children) take_share(child, level, taken, node.records);
    std::vector<NodeFile::Node> rest;
    for (const auto& child : children)
      if (!child.records.empty() || child.has_children)
        rest.push_back({child.level, key_of_cube(child.key), child.records});
    file_->write(rest);
    return node;
  }

  void take_share(OpenNode& child, int level, std::vector<bool>& taken, std::vector<std::uint8_t>& into) const {
    const unsigned shift = OctreeRoot::place_bits - static_cast<unsigned>(level) - OctreeRoot::grid_bits;
    constexpr std::uint32_t mask = (1U << OctreeRoot::grid_bits) - 1;
    std::vector<std::uint8_t> rest;
    for (std::size_t at = 0; at < child.records.size(); at += stride_) {
      const auto* record = &child.records[at];
      const auto place = root_.place(stream_.form.grid, steps_at(record));
      std::size_t cell = 0;
      for (std::size_t k = 0; k < 3; ++k)
        cell |= static_cast<std::size_t>(place[k] >> shift & mask) << (OctreeRoot::grid_bits * k);
      auto& to = taken[cell] ? rest : into;
      to.insert(to.end(), record, record + stride_);
      taken[cell] = true;
    }
    if (!child.has_children && rest.size() / stride_ < options_.octree.min_points) {
      into.insert(into.end(), rest.begin(), rest.end());
      rest.clear();
    }
    child.records = std::move(rest);
  }

  const RecordStream& stream_;
  BuildOptions options_;
  const Run& run_;
  std::size_t stride_, max_in_memory_ = 0;
  int bin_level_ = 0;
  ScratchFolder scratch_;
  OctreeRoot root_;
  las::RecordStatistics box_;
  std::optional<RecordBins> bins_;
  std::uint64_t sorted_ = 0, done_ = 0;
  std::set<std::array<int, 4>> occupied_;
  std::optional<NodeFile> file_;
};

}  // namespace

BuiltFile build_copc(const fs::path& path, const RecordStream& stream, const fs::path& scratch,
                     const BuildOptions& options, const Run& run) {
  return Builder(stream, scratch, options, run).build(path);
}

}  // namespace bole::io::copc
