#include "document/disk_points.h"

#include <algorithm>

#include "cloud/large_cloud.h"

namespace bole::desktop {
namespace {

constexpr std::size_t coarse_points = 400'000;
constexpr std::size_t max_drawn = 2'500'000;  // points; what draws them takes some 150 bytes for each
constexpr double drawn_share = 0.8;           // of the memory, for what one view draws
constexpr auto between_tellings = std::chrono::milliseconds(150);
constexpr std::size_t max_told = 20;  // sentences about damage

std::size_t bytes_of(const PointCloud& cloud) { return cloud.size() * sizeof(Eigen::Vector3f) + columns_bytes(cloud); }

// The spacing of the lowest level down to which the cloud has no more than the points of a coarse sample.
double coarse_spacing(const io::copc::CopcTree& tree) {
  std::vector<std::size_t> points;
  tree.look([&](const auto& nodes) {
    for (const auto& node : nodes) {
      points.resize(std::max(points.size(), static_cast<std::size_t>(node.level) + 1));
      points[static_cast<std::size_t>(node.level)] += node.points;
    }
  });
  std::size_t level = 0, sum = points.empty() ? 0 : points[0];
  while (level + 1 < points.size() && (sum += points[level + 1]) <= coarse_points) ++level;
  return std::ldexp(tree.copc().spacing, -static_cast<int>(level)) * 1.000001;
}

}  // namespace

DiskPoints::DiskPoints(const std::filesystem::path& copc, std::size_t memory_bytes, const Run& run)
    : tree_(copc), memory_limit_(memory_bytes), nothing_(std::make_shared<const PointCloud>()) {
  read_coarse(run);
  const std::size_t each = std::max<std::size_t>(1, bytes_of(*coarse_) / std::max<std::size_t>(1, coarse_->size()));
  max_drawn_ = std::min(
      max_drawn, static_cast<std::size_t>(drawn_share * static_cast<double>(memory_bytes) / static_cast<double>(each)));
  const unsigned threads = std::max(1U, std::thread::hardware_concurrency() - 1);
  for (unsigned k = 0; k < threads; ++k) fetchers_.emplace_back([this](const std::stop_token& stop) { fetch(stop); });
}

DiskPoints::~DiskPoints() {
  for (auto& fetcher : fetchers_) fetcher.request_stop();
  fetchers_.clear();
}

void DiskPoints::read_coarse(const Run& run) {
  io::copc::CopcTree::Query query;
  query.spacing = coarse_spacing(tree_);
  Report report;
  auto cloud = tree_.points_in(query, run, &report);
  for (const auto& finding : report.findings) damage_.push_back(finding.text);
  if (cloud.empty())
    throw bad_input("none of the coarse points of '" + tree_.path().string() + "' can be read", "a whole file",
                    "Copy or download the file again, or convert it to COPC again");
  coarse_ = std::make_shared<const PointCloud>(std::move(cloud));
}

// A column of zeros is left out where a node is decoded; colours are by columns that all nodes have.
std::shared_ptr<const PointCloud> DiskPoints::with_all_columns(PointCloud cloud) const {
  for (const auto& [name, column] : coarse_->columns())
    if (!cloud.has(name)) cloud.set_column(name, make_column(column_type(*column), cloud.size()));
  return std::make_shared<const PointCloud>(std::move(cloud));
}

// Nodes in pages that nobody has read yet are among them, without points: they are awaited like others.
std::vector<std::uint32_t> DiskPoints::choose(const render::OctreeView& view, std::size_t budget, double min_px) {
  auto chosen = tree_.look([&](const auto& nodes) {
    return render::largest_on_screen(
        view, std::min(budget, max_drawn_), min_px,
        [&](std::uint32_t i) {
          const auto& node = nodes[i];
          const double side = tree_.side(node);
          const Eigen::Vector3d centre = tree_.low(node).array() + side / 2;
          return render::NodeCube{(centre - coarse_->origin).template cast<float>(), static_cast<float>(side / 2),
                                  tree_.spacing(node), node.points, node.unread};
        },
        [&](std::uint32_t i, auto&& consider) {
          for (const auto child : nodes[i].children)
            if (child != 0) consider(child);
        });
  });
  const std::scoped_lock lock(mutex_);
  ++time_;
  wanted_.clear();
  for (const auto node : chosen) {
    if (const auto it = loaded_.find(node); it != loaded_.end())
      it->second.last_use = time_;
    else if (!fetching_.contains(node) && !unreadable_.contains(node))
      wanted_.push_back(node);
  }
  if (!wanted_.empty()) asked_.notify_all();
  return chosen;
}

std::size_t DiskPoints::size_of(std::uint32_t node) const { return tree_.node(node).points; }

std::shared_ptr<const PointCloud> DiskPoints::cloud_of(std::uint32_t node) const {
  const std::scoped_lock lock(mutex_);
  if (unreadable_.contains(node)) return nothing_;
  const auto it = loaded_.find(node);
  return it == loaded_.end() ? nullptr : it->second.cloud;
}

render::PointSet DiskPoints::points(std::uint32_t node) const {
  render::PointSet set{cloud_of(node), {}};
  if (!set.cloud) return set;
  set.indices.resize(set.cloud->size());
  for (std::uint32_t i = 0; i < set.indices.size(); ++i) set.indices[i] = i;
  return set;
}

void DiskPoints::fetch(const std::stop_token& stop) {
  while (true) {
    std::uint32_t node = 0;
    {
      std::unique_lock lock(mutex_);
      if (!asked_.wait(lock, stop, [&] { return !wanted_.empty(); })) return;
      node = wanted_.front();
      wanted_.erase(wanted_.begin());
      fetching_.insert(node);
    }
    fetch_node(node);
    if (is_time_to_tell(node)) Q_EMIT arrived();
  }
}

// Each picture costs time: not after every node, but after the last one.
bool DiskPoints::is_time_to_tell(std::uint32_t fetched) {
  const std::scoped_lock lock(mutex_);
  fetching_.erase(fetched);
  const auto now = std::chrono::steady_clock::now();
  if (!wanted_.empty() && now - told_at_ < between_tellings) return false;
  told_at_ = now;
  return true;
}

void DiskPoints::fetch_node(std::uint32_t node) {
  try {
    if (tree_.node(node).unread) {
      tree_.read_page(node);
      return;
    }
    std::vector<std::string> warnings;
    auto cloud = tree_.points(node, warnings);
    ++nodes_read_;
    for (const auto& warning : warnings) tell(QString::fromStdString(warning));
    keep(node, with_all_columns(std::move(cloud)));
  } catch (const std::exception& e) {
    {
      const std::scoped_lock lock(mutex_);
      unreadable_.insert(node);
    }
    tell(QString::fromUtf8(e.what()));
  }
}

void DiskPoints::keep(std::uint32_t node, std::shared_ptr<const PointCloud> cloud) {
  const std::size_t bytes = bytes_of(*cloud);
  const std::scoped_lock lock(mutex_);
  while (!loaded_.empty() && used_ + bytes > memory_limit_) {
    const auto oldest = std::ranges::min_element(loaded_, {}, [](const auto& entry) { return entry.second.last_use; });
    used_ -= oldest->second.bytes;
    loaded_.erase(oldest);
  }
  loaded_[node] = {std::move(cloud), bytes, time_};
  used_ += bytes;
}

void DiskPoints::tell(const QString& what) {
  {
    const std::scoped_lock lock(mutex_);
    if (damage_.size() >= max_told) return;
    damage_.push_back(what.toStdString());
  }
  Q_EMIT damaged(what);
}

std::shared_ptr<const PointCloud> DiskPoints::points_in(const io::copc::CopcTree::Query& query, const Run& run) const {
  return with_all_columns(tree_.points_in(query, run));
}

std::shared_ptr<const PointCloud> DiskPoints::loaded_in(const Eigen::Vector3d& lo, const Eigen::Vector3d& hi) const {
  std::vector<std::shared_ptr<const PointCloud>> clouds;
  {
    const std::scoped_lock lock(mutex_);
    for (const auto& [node, loaded] : loaded_) {
      const auto cube = tree_.node(node);
      const Eigen::Vector3d low = tree_.low(cube), high = low.array() + tree_.side(cube);
      if ((low.array() <= hi.array()).all() && (high.array() >= lo.array()).all()) clouds.push_back(loaded.cloud);
    }
  }
  const Eigen::Vector3d origin = (lo + hi) / 2;
  PointCloud::Positions positions;
  for (const auto& cloud : clouds)
    for (std::size_t i = 0; i < cloud->size(); ++i) {
      const Eigen::Vector3d p = cloud->position(i);
      if ((p.array() >= lo.array()).all() && (p.array() <= hi.array()).all())
        positions.push_back((p - origin).cast<float>());
    }
  return std::make_shared<const PointCloud>(std::move(positions), origin);
}

std::size_t DiskPoints::memory_used() const {
  const std::scoped_lock lock(mutex_);
  return used_;
}

std::size_t DiskPoints::nodes_loaded() const {
  const std::scoped_lock lock(mutex_);
  return loaded_.size();
}

std::vector<std::string> DiskPoints::damage() const {
  auto all = tree_.damage();
  const std::scoped_lock lock(mutex_);
  all.insert(all.end(), damage_.begin(), damage_.end());
  return all;
}

}  // namespace bole::desktop
