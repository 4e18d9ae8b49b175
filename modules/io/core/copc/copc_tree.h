// A COPC file that is looked at in parts: the nodes of its octree become known page by page, and points are decoded
// node by node.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <shared_mutex>
#include <string>
#include <tuple>
#include <unordered_set>
#include <vector>

#include "base/report.h"
#include "base/run.h"
#include "cloud/point_cloud.h"
#include "io/core/bytes/mapped_file.h"
#include "io/core/clouds/cloud_bounds.h"
#include "io/core/copc/copc_entry.h"
#include "io/core/copc/copc_nodes.h"
#include "io/core/las/las_extra_bytes.h"
#include "io/core/las/las_info.h"

namespace bole::io::copc {

struct TreeNode {
  int level = 0;
  Eigen::Vector3i key = Eigen::Vector3i::Zero();  // place among the 2^level cubes of each axis
  std::uint64_t begin = 0, end = 0;               // bytes of its chunk; of its page while that is unread
  std::uint32_t points = 0;
  bool unread = false;                      // it and all below it stand in a page that nobody has read yet
  std::array<std::uint32_t, 8> children{};  // numbers of nodes; 0: none
};

// All members may be called from several threads at a time.
class CopcTree {
 public:
  // Reads header, records and the page of the root. Throws Error{bad_input} naming the file where it is not COPC, or so
  // damaged that no node is known.
  explicit CopcTree(const std::filesystem::path& path);

  const LasInfo& info() const { return info_; }
  const CopcInfo& copc() const { return copc_; }
  const std::filesystem::path& path() const { return path_; }

  // f(const std::vector<TreeNode>&): the nodes that are known, the root first. Their numbers stay; their number grows.
  template <class F>
  auto look(F&& f) const {
    const std::shared_lock lock(mutex_);
    return f(nodes_);
  }
  TreeNode node(std::uint32_t number) const {
    return look([&](const auto& nodes) { return nodes[number]; });
  }
  Eigen::Vector3d low(const TreeNode& node) const;  // the corner of its cube, in the coordinates of the file
  double side(const TreeNode& node) const { return std::ldexp(2 * copc_.half_size, -node.level); }
  double spacing(const TreeNode& node) const { return std::ldexp(copc_.spacing, -node.level); }
  std::size_t pages_read() const;

  // Reads the page that an unread node stands in; nothing to do for others.
  void read_page(std::uint32_t node) const;

  // The points of a node that has been read. Throws Error{bad_input} where none of them can be decoded; where some are
  // missing a warning says so.
  PointCloud points(std::uint32_t node, std::vector<std::string>& warnings) const;

  struct Query {
    CloudBounds box{};   // in the coordinates of the file
    double spacing = 0;  // down to the first level whose points are no further apart; 0: all levels
    // Which of the nodes that meet the box are wanted, from the corners of their cubes; empty: all.
    std::function<bool(const Eigen::Vector3d& low, const Eigen::Vector3d& high)> meets{};
  };
  // Every point within the box once, but those of nodes that are not wanted. Reads the pages that it needs, and decodes
  // no other nodes than those that meet the box. Damage is told in the report. Throws Error{cancelled}.
  PointCloud points_in(const Query& query, const Run& run = {}, Report* report = nullptr) const;

  // Points of the nodes that points_in() would decode: as many as it gives, or more. Throws Error{cancelled}.
  std::uint64_t max_points_in(const Query& query, const Run& run = {}) const;

  // What was found damaged so far, one sentence each.
  std::vector<std::string> damage() const;

 private:
  using Key = std::tuple<int, int, int, int>;
  void take_page(std::uint64_t offset, std::uint64_t size, std::uint32_t of) const;
  void take(const Entry& entry, std::uint32_t page_of) const;
  std::uint32_t place_for(int level, const Eigen::Vector3i& key) const;
  bool fits(const Entry& entry) const;
  void refuse(const std::string& why) const;
  std::vector<laz::Chunk> chunks_in(const Query& query, const Run& run) const;
  PointCloud decode(const std::vector<laz::Chunk>& chunks, const CloudBounds& box, const Run& run,
                    std::uint64_t& missing) const;

  std::filesystem::path path_;
  MappedFile file_;
  LasInfo info_;
  CopcInfo copc_;
  std::vector<las::ExtraDimension> dimensions_;
  Facts facts_;
  mutable std::shared_mutex mutex_;
  mutable std::vector<TreeNode> nodes_;
  mutable std::map<Key, std::uint32_t> places_;
  mutable std::unordered_set<std::uint64_t> pages_, chunks_;  // where those begin that were taken
  mutable std::uint64_t entries_ = 0;
  mutable std::map<std::string, std::size_t> refused_;
};

}  // namespace bole::io::copc
