// The levels of detail of a large cloud, built in the background: a thinned cloud is there at once, the octree later.
#pragma once

#include <QObject>
#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "document/disk_points.h"
#include "render/scene/point_octree.h"

namespace bole::desktop {

class PointIndex : public QObject {
  Q_OBJECT

 public:
  // Small clouds are indexed at once, within `run`; large ones in a thread that leaves one core to the window.
  explicit PointIndex(std::shared_ptr<const PointCloud> cloud, const Run& run = {});
  // For the thread of the window, which never waits: all but tiny clouds are indexed in a thread. Where their points
  // turn out to lie as those of `other` do, its octree is taken.
  PointIndex(std::shared_ptr<const PointCloud> cloud, std::shared_ptr<const PointCloud> other,
             std::shared_ptr<const PointIndex> index_of_other);
  // Of a cloud on disk: the octree is that of its coarse points.
  explicit PointIndex(std::shared_ptr<DiskPoints> disk);
  ~PointIndex() override;  // ends the building within a fraction of a second

  std::shared_ptr<const render::PointOctree> octree() const;  // a sample of the cloud until it is complete
  // All points within a box, in any order; `cloud` is the one that is indexed, or another whose points lie as its do.
  // Until the octree is complete every point is looked at: what is measured is measured on all of them.
  std::vector<std::uint32_t> in_box(const PointCloud& cloud, const Eigen::Vector3f& lo,
                                    const Eigen::Vector3f& hi) const;
  // The points within a box in world coordinates that can be had without waiting: of a cloud on disk those of the nodes
  // that are in memory. The cloud that the indices are of comes with them.
  render::PointSet points_at_once(const std::shared_ptr<const PointCloud>& cloud, const Eigen::Vector3d& lo,
                                  const Eigen::Vector3d& hi) const;
  const std::shared_ptr<DiskPoints>& disk() const { return disk_; }  // null where all points are in memory
  bool complete() const { return complete_; }

 Q_SIGNALS:
  void built();  // from the thread that built it

 private:
  void build_in_thread(std::function<std::shared_ptr<const render::PointOctree>(const Run&)> make);
  void take(std::shared_ptr<const render::PointOctree> octree);

  mutable std::mutex mutex_;
  std::shared_ptr<const render::PointOctree> octree_;
  std::shared_ptr<DiskPoints> disk_;
  std::atomic<bool> complete_ = false;
  std::jthread builder_;
};

// Whether two clouds are of the same points, attributes aside.
bool same_places(const PointCloud& a, const PointCloud& b);

}  // namespace bole::desktop
