// Where a track is in the world, by the poses of the views that see it.
#pragma once

#include <optional>
#include <vector>

#include "rgbd/core/poses/tracks.h"
#include "rgbd/core/poses/view_data.h"

namespace bole::rgbd {

// Both arguments must outlive it. Views without a pose say nothing.
class StartPoints {
 public:
  StartPoints(const std::vector<ViewData>& data, const std::vector<std::optional<Pose>>& poses)
      : data_(data), poses_(poses) {}

  // The measured depth that the views agree with best, or where their rays meet. Nothing where the views disagree by
  // more than `max_error_px` (median), or the rays are nearly parallel.
  std::optional<Eigen::Vector3d> of(const std::vector<TrackedFeature>& track, double max_error_px) const;

 private:
  double miss(const std::vector<TrackedFeature>& track, const Eigen::Vector3d& point) const;
  const Feature& feature(const TrackedFeature& t) const;

  const std::vector<ViewData>& data_;
  const std::vector<std::optional<Pose>>& poses_;
};

}  // namespace bole::rgbd
