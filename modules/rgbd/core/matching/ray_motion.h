// The motion between two views, and of one view to known points, where no depth was measured.
#pragma once

#include <optional>
#include <vector>

#include "rgbd/core/matching/rigid_motion.h"

namespace bole::rgbd {

// The motion that the rays of most matches agree with, its shift of length 1 (essential matrix by five points: Nister
// 2004). Nothing where fewer than min_inliers agree.
std::optional<Motion> find_motion_of_rays(const std::vector<RayMatch>& matches, const MotionOptions& options);

// A point of the world and the direction (x / z, y / z, 1) in which a camera sees it.
struct PointRay {
  Eigen::Vector3d point, ray;
};

struct FoundView {
  Pose T_world_camera = Pose::Identity();
  int inliers = 0;
};

// The pose of a camera by points that it sees, some of them wrongly. Nothing where fewer than min_inliers agree.
std::optional<FoundView> find_view(const std::vector<PointRay>& sights, const MotionOptions& options);

}  // namespace bole::rgbd
