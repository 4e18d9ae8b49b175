#include "document/point_index.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cstring>
#include <exception>

namespace bole::desktop {
namespace {

constexpr std::size_t built_at_once = 2'000'000, sample_points = 1'500'000;
// In the thread of the window: some milliseconds.
constexpr std::size_t built_unnoticed = 50'000, sample_unnoticed = 300'000;

}  // namespace

PointIndex::PointIndex(std::shared_ptr<const PointCloud> cloud, const Run& run) {
  if (cloud->size() <= built_at_once) {
    take(std::make_shared<const render::PointOctree>(*cloud, run));
    return;
  }
  octree_ = std::make_shared<const render::PointOctree>(render::PointOctree::sample(*cloud, sample_points));
  build_in_thread([cloud = std::move(cloud)](const Run& in_background) {
    return std::make_shared<const render::PointOctree>(*cloud, in_background);
  });
}

PointIndex::PointIndex(std::shared_ptr<const PointCloud> cloud, std::shared_ptr<const PointCloud> other,
                       std::shared_ptr<const PointIndex> index_of_other) {
  if (cloud->size() <= built_unnoticed) {
    take(std::make_shared<const render::PointOctree>(*cloud));
    return;
  }
  octree_ = std::make_shared<const render::PointOctree>(render::PointOctree::sample(*cloud, sample_unnoticed));
  build_in_thread([cloud = std::move(cloud), other = std::move(other),
                   index_of_other = std::move(index_of_other)](const Run& in_background) {
    const bool same = other && index_of_other && index_of_other->complete() && same_places(*cloud, *other);
    return same ? index_of_other->octree() : std::make_shared<const render::PointOctree>(*cloud, in_background);
  });
}

PointIndex::PointIndex(std::shared_ptr<DiskPoints> disk) : disk_(std::move(disk)) {
  take(std::make_shared<const render::PointOctree>(*disk_->coarse()));
}

void PointIndex::build_in_thread(std::function<std::shared_ptr<const render::PointOctree>(const Run&)> make) {
  builder_ = std::jthread([this, make = std::move(make)](const std::stop_token& cancel) {
    Run in_background;
    in_background.cancel = cancel;
    tbb::task_arena arena(std::max(1, tbb::this_task_arena::max_concurrency() - 1));
    try {
      arena.execute([&] { take(make(in_background)); });
      Q_EMIT built();
    } catch (const std::exception&) {
      // Cancelled, or no memory for it: the sample stays.
    }
  });
}

PointIndex::~PointIndex() {
  builder_.request_stop();
  if (builder_.joinable()) builder_.join();
}

std::shared_ptr<const render::PointOctree> PointIndex::octree() const {
  const std::scoped_lock lock(mutex_);
  return octree_;
}

std::vector<std::uint32_t> PointIndex::in_box(const PointCloud& cloud, const Eigen::Vector3f& lo,
                                              const Eigen::Vector3f& hi) const {
  if (complete_) return octree()->in_box(lo, hi);
  std::vector<std::uint32_t> found;
  const auto& positions = cloud.positions();
  for (std::size_t i = 0; i < positions.size(); ++i)
    if ((positions[i].array() >= lo.array()).all() && (positions[i].array() <= hi.array()).all())
      found.push_back(static_cast<std::uint32_t>(i));
  return found;
}

render::PointSet PointIndex::points_at_once(const std::shared_ptr<const PointCloud>& cloud, const Eigen::Vector3d& lo,
                                            const Eigen::Vector3d& hi) const {
  if (!disk_) return {cloud, in_box(*cloud, (lo - cloud->origin).cast<float>(), (hi - cloud->origin).cast<float>())};
  render::PointSet set{disk_->loaded_in(lo, hi), {}};
  for (std::uint32_t i = 0; i < set.cloud->size(); ++i) set.indices.push_back(i);
  return set;
}

void PointIndex::take(std::shared_ptr<const render::PointOctree> octree) {
  const std::scoped_lock lock(mutex_);
  octree_ = std::move(octree);
  complete_ = true;
}

bool same_places(const PointCloud& a, const PointCloud& b) {
  const auto &p = a.positions(), &q = b.positions();
  return p.size() == q.size() && a.origin == b.origin &&
         (p.data() == q.data() || std::memcmp(p.data(), q.data(), p.size() * sizeof(Eigen::Vector3f)) == 0);
}

}  // namespace bole::desktop
