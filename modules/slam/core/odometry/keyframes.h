// Key frames: de-skewed features of chosen frames, and the local map made of those nearest to a place.
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
  double path_m = 0;                           // way walked until here
  Pose T_map_keyframe = Pose::Identity();      // at the end of its frame
  std::vector<Eigen::Vector3f> edges, planes;  // in key-frame axes, de-skewed
  ScanContext context;                         // empty unless loops are looked for by appearance
};

// `features` brought to the end pose of `motion`.
Keyframe make_keyframe(std::size_t frame, double time_s, const FeatureSet& features, const FrameMotion& motion);

void insert_keyframe(const Keyframe& keyframe, FeatureMaps& maps);

// The map about the place where the sensor is: the `most` key frames nearest to it, or the last ones, and, so that it
// is built anew only now and then, up to half as many that were so before.
class LocalMap {
 public:
  LocalMap(double cell_m, std::size_t most, bool of_last = false) : maps_(cell_m), most_(most), of_last_(of_last) {}

  // Call after a key frame was added, or with `moved` after poses changed.
  void update(const std::vector<Keyframe>& keyframes, const Eigen::Vector3d& place, bool moved = false);
  const FeatureMaps& maps() const { return maps_; }

 private:
  FeatureMaps maps_;
  std::size_t most_;
  bool of_last_;
  std::vector<std::size_t> members_;  // rising
};

}  // namespace bole::slam
