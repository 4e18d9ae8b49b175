// Snapshots of a SLAM run for a preview (cloud/preview.h). A snapshot has these parts, each only when it has changed:
//   frame            cloud       the current frame, de-skewed, map axes
//   frame_state      table       one row: frame (index in the source), frames (in the source), ok, overlap, time_s
//   trajectory       trajectory  poses so far, map axes
//   keyframe_points  cloud       thinned points of keyframes that are new since the last snapshot, in the axes of their
//                                keyframe; column keyframe
//   keyframes        trajectory  poses of all keyframes, map axes; a later snapshot may move them
//   loops            table       from_keyframe, to_keyframe, accepted: all loop closures tried so far
#pragma once

#include <utility>
#include <vector>

#include "base/run.h"
#include "slam/core/loops/loops.h"
#include "slam/core/map/path.h"
#include "slam/core/odometry/odometry.h"

namespace bole::slam {

// Shows the odometry while it runs.
class FollowPreview {
 public:
  FollowPreview(const Run& run, std::size_t frames) : preview_(run.preview), frames_(frames) {}

  // Call after a frame was added to the odometry. Shows it when a snapshot is wanted.
  void frame(const Odometry& odometry, const Features& features);
  // Call after the last frame.
  void all(const Odometry& odometry);

 private:
  void show(const Odometry& odometry, const Features* features);
  std::shared_ptr<Preview> preview_;
  std::size_t frames_;
  std::size_t shown_keyframes_ = 0;
};

// Loop closures as pairs of keyframes. `last`: the search is over, so show them in any case.
void preview_loops(const Run& run, const std::vector<Loop>& accepted,
                   const std::vector<std::pair<std::size_t, std::size_t>>& refused, bool last);

// The poses after a step that changed them.
void preview_poses(const Run& run, const std::vector<TrackedFrame>& frames, const std::vector<Keyframe>& keyframes);
void preview_path(const Run& run, const Path& path, const std::vector<Keyframe>& keyframes);

}  // namespace bole::slam
