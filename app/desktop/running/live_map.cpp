#include "running/live_map.h"

#include <algorithm>
#include <utility>

namespace bole::desktop {

void LiveMap::add(const DataSet& snapshot) {
  if (snapshot.has("trajectory")) path_ = snapshot.get<Trajectory>("trajectory");
  if (snapshot.has("keyframes")) move_to(snapshot.trajectory("keyframes"));
  if (snapshot.has("keyframe_points")) add_points(snapshot.cloud("keyframe_points"));
  if (snapshot.has("frame")) frame_ = snapshot.get<PointCloud>("frame");
  if (snapshot.has("frame_state")) {
    const auto& t = snapshot.table("frame_state");
    state_ = State{t.integers("frame")[0], t.integers("frames")[0], t.numbers("time_s")[0], t.numbers("overlap")[0],
                   t.integers("ok")[0] != 0};
  }
  if (snapshot.has("loops")) {
    const auto& t = snapshot.table("loops");
    const auto from = t.integers("from_keyframe"), to = t.integers("to_keyframe"), good = t.integers("accepted");
    loops_.clear();
    for (std::size_t i = 0; i < from.size(); ++i) {
      const auto a = static_cast<std::size_t>(from[i]), b = static_cast<std::size_t>(to[i]);
      if (a < keyframes_.size() && b < keyframes_.size()) loops_.push_back({a, b, good[i] != 0});
    }
  }
}

void LiveMap::move_to(const Trajectory& poses) {
  constexpr double moved = 1e-3;  // metres; of the matrix of the rotation
  while (keyframes_.size() > poses.poses.size()) {
    points_ -= keyframes_.back().points.size();
    keyframes_.pop_back();
  }
  first_changed_ = std::min(first_changed_, keyframes_.size());
  for (std::size_t k = 0; k < poses.poses.size(); ++k) {
    const auto& pose = poses.poses[k];
    if (k == keyframes_.size()) {
      keyframes_.push_back({pose.time_s, pose.T_target_sensor, {}});
      continue;
    }
    auto& T = keyframes_[k].T_map_keyframe;
    if ((T.matrix() - pose.T_target_sensor.matrix()).cwiseAbs().maxCoeff() < moved) continue;
    T = pose.T_target_sensor;
    first_changed_ = std::min(first_changed_, k);
  }
}

void LiveMap::add_points(const PointCloud& cloud) {
  const auto& of = cloud.values<std::int32_t>(arrays::keyframe);
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const auto k = static_cast<std::size_t>(of[i]);
    if (k >= keyframes_.size()) continue;
    keyframes_[k].points.push_back(cloud.positions()[i]);
    first_changed_ = std::min(first_changed_, k);
    ++points_;
  }
}

std::size_t LiveMap::take_first_changed() { return std::exchange(first_changed_, keyframes_.size()); }

}  // namespace bole::desktop
