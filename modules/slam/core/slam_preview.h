// What somebody who watches a SLAM run gets to see of it (cloud/preview.h). Parts of a snapshot, each only when it has
// news:
//   frame            cloud       the frame in work, de-skewed, map axes
//   frame_state      table       one row: frame (index in the source), frames (in the source), ok, overlap, time_s
//   trajectory       trajectory  poses so far, map axes
//   keyframe_points  cloud       thinned points of key frames that no snapshot held before, in the axes of their key
//                                frame; column keyframe
//   keyframes        trajectory  poses of all key frames, map axes; a later snapshot may move them
//   loops            table       from_keyframe, to_keyframe, accepted: all revisits tried so far
#pragma once

#include <utility>
#include <vector>

#include "base/run.h"
#include "slam/core/loops/loops.h"
#include "slam/core/map/path.h"
#include "slam/core/odometry/odometry.h"

namespace bole::slam {

// While frames are followed.
class FollowPreview {
 public:
  FollowPreview(const Run& run, std::size_t frames) : preview_(run.preview), frames_(frames) {}

  // After a frame was added to the odometry: shows it when a snapshot is wanted.
  void frame(const Odometry& odometry, const Features& features);
  // After the last one.
  void all(const Odometry& odometry);

 private:
  void show(const Odometry& odometry, const Features* features);
  std::shared_ptr<Preview> preview_;
  std::size_t frames_;
  std::size_t shown_keyframes_ = 0;
};

// Revisits as pairs of key frames; `last`: the search is over, show them whether a snapshot is wanted or not.
void preview_loops(const Run& run, const std::vector<Loop>& accepted,
                   const std::vector<std::pair<std::size_t, std::size_t>>& refused, bool last);

// The poses after a step that moved them.
void preview_poses(const Run& run, const std::vector<TrackedFrame>& frames, const std::vector<Keyframe>& keyframes);
void preview_path(const Run& run, const Path& path, const std::vector<Keyframe>& keyframes);

}  // namespace bole::slam
