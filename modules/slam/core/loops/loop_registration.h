// The relative pose of a revisit, by the ways that systems differ in.
#pragma once

#include <string>

#include "slam/core/odometry/keyframes.h"
#include "slam/core/options.h"

namespace bole::slam {

// What a key frame is held against: the key frames of one stretch of the walk, in map axes.
class LoopTarget {
 public:
  LoopTarget(const std::vector<Keyframe>& keyframes, std::size_t first, std::size_t last, const SlamOptions& options);

  // From `guess` on: "features" (edges and planes, SPEC A8), "icp" (LeGO-LOAM), "ndt_icp" (SPEC D2). Overlap, rms and
  // information are always those of the edges and planes at the pose that was found, so that one rule judges them all.
  Registration registered(const Keyframe& keyframe, const Pose& guess, const Run& run) const;

 private:
  const SlamOptions& options_;
  FeatureMaps maps_;
  std::vector<Eigen::Vector3f> points_;  // about the first key frame of the stretch
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
};

}  // namespace bole::slam
