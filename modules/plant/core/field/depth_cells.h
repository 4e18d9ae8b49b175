// Which cells of a field are worth sampling: those near a measured depth.
#pragma once

#include <atomic>
#include <vector>

#include "plant/core/field/field_space.h"
#include "plant/core/surface/posed_views.h"

namespace bole::plant {

// Cells that the depth of at least two views marks (of one, where there are few views). Thin parts count although most
// views look past them.
class DepthCells {
 public:
  DepthCells(const FieldSpace& space, DepthNoise noise);

  // Depth in the axes of the depth camera.
  void add(const DepthImage& depth, const CameraModel& camera, const Pose& T_world_depth);
  // Masks by place in box `box`.
  const std::vector<std::uint64_t>& cells(std::size_t box) const { return views_ < 6 ? once_[box] : twice_[box]; }
  std::size_t block_count() const;

 private:
  void mark(const Eigen::Vector3f& p);

  const FieldSpace& space_;
  DepthNoise noise_;
  int views_ = 0;
  std::vector<std::vector<std::atomic<std::uint64_t>>> now_;
  std::vector<std::vector<std::uint64_t>> once_, twice_;
};

// All cells of the innermost box: for views without depth.
std::vector<std::uint64_t> all_cells(const FieldBox& box);

}  // namespace bole::plant
