// What a solution of the pose graph changes: a correction of the map axes for every time of the walk.
#pragma once

#include <vector>

#include "cloud/trajectory.h"
#include "slam/core/odometry/keyframes.h"

namespace bole::slam {

class Corrections {
 public:
  // One for each keyframe: new pose = correction * old pose. At least one keyframe, in order of time.
  Corrections(const std::vector<double>& times_s, const std::vector<Pose>& T_map_before,
              const std::vector<Pose>& T_map_after);

  // Interpolated between keyframes, held beyond the first and the last one, so that a path stays continuous.
  Pose at(double time_s) const;

 private:
  std::vector<StampedPose> corrections_;
};

}  // namespace bole::slam
