// The map of a SLAM run as its snapshots give it (slam/core/slam_preview.h): keyframes with their points and poses,
// the path so far, revisits, the frame in work.
#pragma once

#include <optional>
#include <vector>

#include "cloud/data.h"

namespace bole::desktop {

class LiveMap {
 public:
  struct Keyframe {
    double time_s = 0;
    Pose T_map_keyframe = Pose::Identity();
    std::vector<Eigen::Vector3f> points;  // in its own axes
  };
  struct Loop {
    std::size_t from = 0, to = 0;  // keyframes
    bool accepted = false;
  };
  struct State {
    std::int64_t frame = 0, frames = 0;  // index in the source, and how many it has
    double time_s = 0, overlap = 0;
    bool ok = true;
  };

  // Takes a snapshot over. Parts that are not of a SLAM run are ignored.
  void add(const DataSet& snapshot);

  bool empty() const { return keyframes_.empty(); }
  const std::vector<Keyframe>& keyframes() const { return keyframes_; }
  const std::shared_ptr<const Trajectory>& path() const { return path_; }  // null before the first pose
  const std::vector<Loop>& loops() const { return loops_; }                // those between known keyframes
  const std::shared_ptr<const PointCloud>& frame() const { return frame_; }
  const std::optional<State>& state() const { return state_; }
  std::size_t points() const { return points_; }

  // Key frames from here on are new or have moved since the last call.
  std::size_t take_first_changed();

 private:
  void add_points(const PointCloud& cloud);
  void move_to(const Trajectory& poses);

  std::vector<Keyframe> keyframes_;
  std::vector<Loop> loops_;
  std::shared_ptr<const Trajectory> path_;
  std::shared_ptr<const PointCloud> frame_;
  std::optional<State> state_;
  std::size_t first_changed_ = 0, points_ = 0;
};

}  // namespace bole::desktop
