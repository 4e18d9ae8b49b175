#include "slam/core/slam_preview.h"

#include <algorithm>

#include "cloud/preview.h"

namespace bole::slam {
namespace {

constexpr std::size_t points_per_keyframe = 1000, points_per_frame = 4000;

Trajectory poses_of(const std::vector<TrackedFrame>& frames) {
  Trajectory t;
  t.poses.reserve(frames.size());
  for (const auto& f : frames)
    if (f.ok) t.poses.push_back({f.end_s, f.motion.T_map_end});
  return t;
}

Trajectory poses_of(const std::vector<Keyframe>& keyframes) {
  Trajectory t;
  t.poses.reserve(keyframes.size());
  for (const auto& k : keyframes) t.poses.push_back({k.time_s, k.T_map_keyframe});
  return t;
}

// Every nth, so that at most `max_points` are left.
template <class Points, class Add>
void thinned(const Points& points, std::size_t max_points, Add add) {
  const std::size_t step = points.size() / max_points + 1;
  for (std::size_t i = 0; i < points.size(); i += step) add(points[i]);
}

PointCloud points_of(const std::vector<Keyframe>& keyframes, std::size_t first) {
  PointCloud::Positions positions;
  std::vector<std::int32_t> of;
  for (std::size_t k = first; k < keyframes.size(); ++k) {
    const auto add = [&](const Eigen::Vector3f& p) {
      positions.push_back(p);
      of.push_back(static_cast<std::int32_t>(k));
    };
    thinned(keyframes[k].edges, points_per_keyframe / 2, add);
    thinned(keyframes[k].planes, points_per_keyframe / 2, add);
  }
  PointCloud cloud(std::move(positions));
  cloud.axes = Axes::sensor;
  cloud.set_column(arrays::keyframe, std::move(of));
  return cloud;
}

PointCloud points_of(const Features& features, const FrameMotion& motion) {
  const PoseGrid poses(motion);
  PointCloud::Positions positions;
  const auto add = [&](const FeaturePoint& p) { positions.push_back(poses.in_map(p.position, p.s).cast<float>()); };
  thinned(features.map.edges, points_per_frame / 2, add);
  thinned(features.map.planes, points_per_frame / 2, add);
  PointCloud cloud(std::move(positions));
  cloud.axes = Axes::map;
  return cloud;
}

Table state_of(const TrackedFrame& frame, std::size_t frames) {
  Table t;
  t.set("frame", std::vector<std::int64_t>{static_cast<std::int64_t>(frame.index)});
  t.set("frames", std::vector<std::int64_t>{static_cast<std::int64_t>(frames)});
  t.set("ok", std::vector<std::int64_t>{frame.ok});
  t.set("overlap", std::vector<double>{frame.overlap});
  t.set("time_s", std::vector<double>{frame.end_s});
  return t;
}

}  // namespace

void FollowPreview::frame(const Odometry& odometry, const Features& features) {
  if (preview_ && preview_->wants()) show(odometry, &features);
}

void FollowPreview::all(const Odometry& odometry) {
  if (preview_ && !odometry.frames().empty()) show(odometry, nullptr);
}

void FollowPreview::show(const Odometry& odometry, const Features* features) {
  const auto& last = odometry.frames().back();
  DataSet snapshot;
  if (features) snapshot.set("frame", points_of(*features, last.motion));
  snapshot.set("frame_state", state_of(last, frames_));
  snapshot.set("trajectory", poses_of(odometry.frames()));
  const auto& keyframes = odometry.keyframes();
  // Failed frames at the end are dropped with their keyframes when the track is lost.
  shown_keyframes_ = std::min(shown_keyframes_, keyframes.size());
  if (shown_keyframes_ < keyframes.size()) snapshot.set("keyframe_points", points_of(keyframes, shown_keyframes_));
  shown_keyframes_ = keyframes.size();
  snapshot.set("keyframes", poses_of(keyframes));
  preview_->show(std::move(snapshot));
}

void preview_loops(const Run& run, const std::vector<Loop>& accepted,
                   const std::vector<std::pair<std::size_t, std::size_t>>& refused, bool last) {
  if (!run.preview || (!last && !run.preview->wants())) return;
  std::vector<std::int64_t> from, to, good;
  const auto add = [&](std::size_t a, std::size_t b, bool ok) {
    from.push_back(static_cast<std::int64_t>(a));
    to.push_back(static_cast<std::int64_t>(b));
    good.push_back(ok);
  };
  for (const auto& l : accepted) add(l.from, l.to, true);
  for (const auto& [a, b] : refused) add(a, b, false);
  Table t;
  t.set("from_keyframe", from);
  t.set("to_keyframe", to);
  t.set("accepted", good);
  DataSet snapshot;
  snapshot.set("loops", std::move(t));
  run.preview->show(std::move(snapshot));
}

void preview_poses(const Run& run, const std::vector<TrackedFrame>& frames, const std::vector<Keyframe>& keyframes) {
  if (!run.preview) return;
  DataSet snapshot;
  snapshot.set("trajectory", poses_of(frames));
  snapshot.set("keyframes", poses_of(keyframes));
  run.preview->show(std::move(snapshot));
}

void preview_path(const Run& run, const Path& path, const std::vector<Keyframe>& keyframes) {
  if (!run.preview) return;
  Trajectory walk, places;
  walk.poses = path.nodes();
  for (const auto& k : keyframes)
    if (path.covers(k.time_s, 0.5)) places.poses.push_back({k.time_s, path.at(k.time_s)});
  DataSet snapshot;
  snapshot.set("trajectory", std::move(walk));
  // All or none: poses are assigned to keyframes by their index.
  if (places.poses.size() == keyframes.size()) snapshot.set("keyframes", std::move(places));
  run.preview->show(std::move(snapshot));
}

}  // namespace bole::slam
