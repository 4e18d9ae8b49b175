#include "slam/core/slam.h"

#include <algorithm>
#include <cmath>

#include "base/angles.h"
#include "cloud/known_facts.h"
#include "slam/core/map/dense_map.h"
#include "slam/core/map/passes.h"
#include "slam/core/map/tum_poses.h"
#include "slam/core/odometry/track.h"
#include "slam/core/read_ahead.h"
#include "slam/core/stopwatch.h"

namespace bole::slam {
namespace {

// Poses in projected coordinates are moved to a nearby origin, because float32 offsets are not precise enough.
Eigen::Vector3d near_origin(const std::vector<StampedPose>& poses) {
  const Eigen::Vector3d first = poses.front().T_target_sensor.translation();
  return first.norm() < 5000 ? Eigen::Vector3d::Zero() : Eigen::Vector3d((first / 100).array().round() * 100);
}

void shift(std::vector<StampedPose>& poses, const Eigen::Vector3d& by) {
  for (auto& p : poses) p.T_target_sensor.translation() += by;
}

// False where the frame cannot be read: one bad frame does not end the run.
bool readable(const FrameSource& source, std::size_t index, ScanFrame& frame) {
  try {
    source.read(index, frame);
    return true;
  } catch (const Error& e) {
    if (e.kind() == ErrorKind::cancelled) throw;
    return false;
  }
}

// An estimate from the largest of three frames. More are read only where these cannot be read.
std::size_t expected_points(const FrameSource& source, const Track& track) {
  ScanFrame frame;
  std::size_t max_size = 0;
  int seen = 0;
  for (const double share : {0.1, 0.5, 0.9, 0.3, 0.7, 0.2, 0.4, 0.6, 0.8}) {
    const auto k = static_cast<std::size_t>(share * static_cast<double>(track.frames.size()));
    if (!readable(source, track.frames[k].index, frame)) continue;
    max_size = std::max(max_size, frame.size());
    if (++seen == 3) break;
  }
  return (max_size + max_size / 4 + 1000) * track.frames.size();
}

struct MappedFrame {
  ScanFrame frame;
  bool readable = false;
};

PointCloud map_frames(const FrameSource& source, const Track& track, const SlamSettings& options, Report& report,
                      const Run& run) {
  if (!options.dense_map) return DenseMapBuilder({.expected_points = 1}).take();
  const auto marks = mark_path(track.path, track.keyframe_times_s, options.keyframe_distance, options.pass_radius);
  DenseMapSettings settings;
  settings.min_range = options.map_min_range;
  settings.max_range = options.map_max_range;
  settings.voxel = options.map_voxel;
  settings.points_per_voxel = options.map_points_per_voxel;
  settings.max_points = static_cast<std::size_t>(options.map_max_points_million * 1e6);
  settings.expected_points = expected_points(source, track);
  DenseMapBuilder builder(settings);
  Stopwatch watch;
  ReadAhead<MappedFrame> frames(track.frames.size(), [&](std::size_t k, MappedFrame& out) {
    out.readable = readable(source, track.frames[k].index, out.frame);
  });
  std::size_t unread = 0;
  for (std::size_t k = 0; k < track.frames.size(); ++k) {
    run.check_cancel();
    run.report(static_cast<double>(k) / static_cast<double>(track.frames.size()),
               "mapping frame " + std::to_string(k + 1) + " of " + std::to_string(track.frames.size()));
    const auto& [frame, could_be_read] = frames.take();
    if (!could_be_read) {
      ++unread;
      continue;
    }
    const double begin_s = frame.start_time_s, span_s = frame.end_time_s - frame.start_time_s;
    const auto& mark = mark_at(marks, begin_s + 0.5 * span_s);
    const PoseGrid poses = track.own_motion ? PoseGrid(track.frames[k].motion)
                                            : PoseGrid([&](double s) { return track.path.at(begin_s + s * span_s); });
    builder.add(frame, poses, mark.pass, mark.keyframe);
  }
  if (unread)
    report.warn(std::to_string(unread) + " of " + std::to_string(track.frames.size()) +
                " frames could not be read a second time. They are missing in the map");
  if (builder.halvings() > 0)
    report.warn("the map was thinned to every " + std::to_string(1 << builder.halvings()) +
                "th point to stay below map_max_points, " + number_text(options.map_max_points_million) + " million");
  report.metrics["map_per_frame"] = {1000 * watch.lap() / static_cast<double>(track.frames.size()), Unit::millisecond};
  report.counts["points_offered"] = static_cast<std::int64_t>(builder.offered());
  report.counts["points"] = static_cast<std::int64_t>(builder.size());
  report.counts["passes"] = marks.empty() ? 0 : marks.back().pass + 1;
  return builder.take();
}

// Poses in a gap of the recording are guesses and are left out.
void leave_out_gaps(const std::vector<std::pair<double, double>>& gaps_s, Trajectory& trajectory) {
  std::erase_if(trajectory.poses, [&](const StampedPose& p) {
    return std::ranges::any_of(gaps_s, [&](const auto& gap) { return p.time_s > gap.first && p.time_s < gap.second; });
  });
}

// Beams that never repeat their path have no scan lines: curvature along a line and ground between lines mean nothing.
void suit_rosette(const SlamOptions& given, SlamSettings& options, Report& report) {
  if (!options.trajectory.empty() || options.features == FeatureKind::sampled) return;
  if (given.features)
    throw bad_input("features " + std::string(choice_name(options.features)) +
                        " need scan lines, and the beams of this scanner never repeat their path",
                    "features sampled", "Leave the option features to the preset, or set it to sampled");
  report.facts["features"] = "sampled, since the scanner has no scan lines";
  options.features = FeatureKind::sampled;
  // Neighbours on a scan line and beside it cannot be told either.
  if (options.first_guess == FirstGuess::matched_motion) options.first_guess = FirstGuess::last_frame;
}

// Measured on simulated plots 1 to 4 (docs/dev/slam-paper-tables.md).
void tell_preset_for_comparison(Preset preset, Report& report) {
  using enum Preset;
  if (preset != loam && preset != forest && preset != loam_paper && preset != forest_paper) return;
  report.find(
      Severity::look, "preset_for_comparison",
      "preset " + std::string(choice_name(preset)) +
          " repeats a published method, for comparison. On simulated plots such presets made walks up to 0.5 % too "
          "short and bent the map by centimetres: distances are wrong by that, and diameters uncertain. For a survey "
          "use preset=best");
}

}  // namespace

SlamResult run_slam(const FrameSource& source, const SlamOptions& given, const Run& run) {
  SlamSettings options = resolved(given);
  if (source.size() == 0) throw bad_input("the scan has no frames", "at least 2");
  SlamResult out;
  if (source.pattern() == ScanPattern::rosette) suit_rosette(given, options, out.report);
  out.report.facts["preset"] = choice_name(options.preset);
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Track track;
  if (options.trajectory.empty()) {
    track = estimate_track(source, options, out.report, run.part(0, 0.75));
    tell_preset_for_comparison(options.preset, out.report);  // behind what went wrong
  } else {
    auto poses = read_tum_poses(options.trajectory);
    origin = near_origin(poses);
    shift(poses, -origin);
    track = given_track(source, poses, out.report, run);
    out.report.facts["trajectory"] = options.trajectory;
  }
  out.points = map_frames(source, track, options, out.report, options.trajectory.empty() ? run.part(0.75, 1) : run);
  out.odometry = std::move(track.frame_table);
  out.loops = std::move(track.loop_table);
  out.loop_candidates = std::move(track.candidate_table);
  out.pose_graph = std::move(track.graph_table);
  out.points.origin = origin;
  out.trajectory = track.path.sampled(options.trajectory_rate, Axes::map);
  leave_out_gaps(track.gaps_s, out.trajectory);
  shift(out.trajectory.poses, origin);

  Facts known = source.facts();
  set_fact(known, options.trajectory.empty() ? PoseOrigin::estimated : PoseOrigin::given);
  if (track.level_sigma_rad) set_fact(known, facts::level_sigma, degrees(*track.level_sigma_rad));
  // Published figures are shown beside the results of the preset that they are of (evaluation.plot).
  if (options.trajectory.empty()) known["preset"] = std::string(choice_name(options.preset));
  out.points.facts = known;
  out.trajectory.facts = std::move(known);

  auto& report = out.report;
  report.facts["axes"] = std::string(axes_name(Axes::map));
  report.metrics["path_length"] = {out.trajectory.length_m(), Unit::metre};
  report.metrics["duration"] = {track.path.end_s() - track.path.begin_s(), Unit::second};
  report.message = std::to_string(track.frames.size()) + " of " + std::to_string(source.size()) + " frames " +
                   (options.dense_map ? "mapped to " + std::to_string(out.points.size()) + " points" : "followed") +
                   " along " + number_text(std::round(report.metrics["path_length"].value * 10) / 10) + " m" +
                   (options.trajectory.empty() ? "" : " with the given trajectory");
  return out;
}

}  // namespace bole::slam
