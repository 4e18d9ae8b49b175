// Keyframes: de-skewed features of selected frames, and the local map made of those nearest to the sensor.
#pragma once

#include <vector>

#include "slam/core/loops/scan_context.h"
#include "slam/core/odometry/features.h"
#include "slam/core/odometry/motion.h"
#include "slam/core/odometry/registration.h"

namespace bole::slam {

struct Keyframe {
  std::size_t frame = 0;                       // index among the frames of the track
  double time_s = 0;                           // of its pose
  double travelled = 0;                        // distance travelled so far
  Pose T_map_keyframe = Pose::Identity();      // at the end of its frame
  std::vector<Eigen::Vector3f> edges, planes;  // in keyframe axes, de-skewed
  ScanContext context;                         // empty unless loops are looked for by their surroundings
};

// `features` moved to the end pose of `motion`.
Keyframe make_keyframe(std::size_t frame, double time_s, const FeatureSet& features, const FrameMotion& motion);

void insert_keyframe(const Keyframe& keyframe, FeatureMaps& maps);

// The map around the sensor: the `max_keyframes` keyframes nearest to it, or the last ones. Up to half as many that
// were members before stay in it, so that the map is seldom rebuilt.
class LocalMap {
 public:
  LocalMap(double cell_size, std::size_t max_keyframes, LocalMapKind kind = LocalMapKind::nearest)
      : maps_(cell_size), max_keyframes_(max_keyframes), kind_(kind) {}

  // Call after a keyframe was added, or with `moved` after poses changed.
  void update(const std::vector<Keyframe>& keyframes, const Eigen::Vector3d& place, bool moved = false);
  const FeatureMaps& maps() const { return maps_; }

 private:
  FeatureMaps maps_;
  std::size_t max_keyframes_;
  LocalMapKind kind_;
  std::vector<std::size_t> members_;  // ascending
};

}  // namespace bole::slam
