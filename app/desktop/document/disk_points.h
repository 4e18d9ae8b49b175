// A cloud on disk as the window sees it: the nodes of a COPC file, fetched when a view wants them.
#pragma once

#include <QObject>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <thread>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "io/core/copc/copc_tree.h"
#include "render/scene/point_nodes.h"

namespace bole::desktop {

// Decoded nodes stay in memory up to a limit; those that no view has wanted for the longest time go first. Threads,
// which leave one processor to the window, fetch what the last view chose, in the order of its size on the screen; what
// was asked for before and is not wanted any more is never begun. Nothing here makes the thread of the window wait for
// the disk but points_in().
class DiskPoints : public QObject, public render::PointNodes {
  Q_OBJECT

 public:
  static constexpr std::size_t default_memory_bytes = std::size_t{1} << 30;

  // Reads the coarse levels. Throws bole::Error where the file cannot be used.
  explicit DiskPoints(const std::filesystem::path& copc, std::size_t memory_bytes = default_memory_bytes,
                      const Run& run = {});
  ~DiskPoints() override;  // ends within the time that one node takes

  std::uint64_t size() const { return tree_.info().points; }
  // The points of the coarse levels, an even sample of the cloud: for ranges of colours and extents.
  const std::shared_ptr<const PointCloud>& coarse() const { return coarse_; }
  const io::copc::CopcTree& tree() const { return tree_; }

  // Every point of a query once, from the disk. For threads other than that of the window.
  std::shared_ptr<const PointCloud> points_in(const io::copc::CopcTree::Query& query, const Run& run) const;
  // The points in a box of those nodes that are in memory, world coordinates: at once.
  std::shared_ptr<const PointCloud> loaded_in(const Eigen::Vector3d& lo, const Eigen::Vector3d& hi) const;

  std::size_t memory_limit() const { return memory_limit_; }
  std::size_t memory_used() const;                        // by decoded nodes
  std::size_t nodes_loaded() const;                       // now
  std::size_t nodes_read() const { return nodes_read_; }  // so far; more than were loaded where some came twice
  std::vector<std::string> damage() const;

  Eigen::Vector3d origin() const override { return coarse_->origin; }
  std::vector<std::uint32_t> choose(const render::OctreeView& view, std::size_t budget, double min_px) override;
  std::size_t size_of(std::uint32_t node) const override;
  render::PointSet points(std::uint32_t node) const override;
  std::shared_ptr<const PointCloud> cloud_of(std::uint32_t node) const override;
  std::size_t max_prepared() const override { return max_drawn_; }

 Q_SIGNALS:
  // From the thread that fetches. Nodes that were awaited are here; told some times a second at most.
  void arrived();
  void damaged(const QString& what);

 private:
  struct Loaded {
    std::shared_ptr<const PointCloud> cloud;
    std::size_t bytes = 0;
    std::uint64_t last_use = 0;
  };
  void read_coarse(const Run& run);
  void fetch(const std::stop_token& stop);
  void fetch_node(std::uint32_t node);
  bool is_time_to_tell(std::uint32_t fetched);
  std::shared_ptr<const PointCloud> with_all_columns(PointCloud cloud) const;
  void keep(std::uint32_t node, std::shared_ptr<const PointCloud> cloud);
  void tell(const QString& what);

  io::copc::CopcTree tree_;
  std::size_t memory_limit_, max_drawn_ = 0;  // bytes, points
  std::shared_ptr<const PointCloud> coarse_, nothing_;
  mutable std::mutex mutex_;
  std::condition_variable_any asked_;
  std::vector<std::uint32_t> wanted_;  // the most important first
  std::unordered_map<std::uint32_t, Loaded> loaded_;
  std::unordered_set<std::uint32_t> fetching_, unreadable_;
  std::vector<std::string> damage_;
  std::size_t used_ = 0;
  std::uint64_t time_ = 0;  // counts choices
  std::atomic<std::size_t> nodes_read_ = 0;
  std::chrono::steady_clock::time_point told_at_;
  std::vector<std::jthread> fetchers_;
};

}  // namespace bole::desktop
