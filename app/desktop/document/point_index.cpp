#include "document/point_index.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <exception>

namespace bole::desktop {
namespace {

constexpr std::size_t built_at_once = 2'000'000, sample_points = 1'500'000;

}  // namespace

PointIndex::PointIndex(std::shared_ptr<const PointCloud> cloud, const Run& run) {
  if (cloud->size() <= built_at_once) {
    build(*cloud, run);
    return;
  }
  octree_ = std::make_shared<const PointOctree>(PointOctree::sample(*cloud, sample_points));
  builder_ = std::jthread([this, cloud = std::move(cloud)](const std::stop_token& cancel) {
    Run in_background;
    in_background.cancel = cancel;
    tbb::task_arena arena(std::max(1, tbb::this_task_arena::max_concurrency() - 1));
    try {
      arena.execute([&] { build(*cloud, in_background); });
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

std::shared_ptr<const PointOctree> PointIndex::octree() const {
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

void PointIndex::build(const PointCloud& cloud, const Run& run) {
  auto octree = std::make_shared<const PointOctree>(cloud, run);
  const std::scoped_lock lock(mutex_);
  octree_ = std::move(octree);
  complete_ = true;
}

}  // namespace bole::desktop
