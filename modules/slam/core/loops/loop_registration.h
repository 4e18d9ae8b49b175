// The relative pose of a loop closure, by the methods of the different systems.
#pragma once

#include <string>

#include "slam/core/odometry/keyframes.h"
#include "slam/core/options.h"

namespace bole::slam {

struct LoopRegistration {
  Registration registration;
  // Of ICP, with or without NDT before it: whether it converged, and the distances to the closest points (root mean
  // square).
  bool converged = false;
  double closest_rms = 0;
};

// What a keyframe is registered against: the keyframes of one stretch of the walk, in map axes.
class LoopTarget {
 public:
  LoopTarget(const std::vector<Keyframe>& keyframes, std::size_t first, std::size_t last, const SlamSettings& settings);

  // Registers from `guess` on by settings.loop_registration: edges and planes (SPEC A8), ICP (LeGO-LOAM), or NDT and
  // ICP (SPEC D2). Overlap, rms and information are always those of the edges and planes at the pose that was found, so
  // that one rule applies to all methods.
  LoopRegistration registered(const Keyframe& keyframe, const Pose& guess, const Run& run) const;

 private:
  const SlamSettings& settings_;
  FeatureMaps maps_;
  std::vector<Eigen::Vector3f> points_;  // relative to the first keyframe of the stretch
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
};

}  // namespace bole::slam
