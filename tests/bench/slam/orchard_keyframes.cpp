#include "slam/orchard_keyframes.h"

#include <cmath>
#include <numbers>
#include <random>

#include "slam/core/loops/context_index.h"
#include "slam/core/odometry/odometry.h"

namespace bole {
namespace {

constexpr double rad(double deg) { return deg * std::numbers::pi / 180; }

slam::ScanGate gate_of(const FrameSource& source, const slam::SlamSettings& options) {
  return {options.min_range, options.max_range, source.rings() > 0 ? source.rings() : 1024};
}

}  // namespace

std::vector<slam::Keyframe> followed_keyframes(const FrameSource& source, const slam::SlamSettings& options,
                                               std::size_t most_frames) {
  slam::FeatureExtractor extractor(options);
  slam::Odometry odometry(options);
  ScanFrame frame;
  slam::Scan scan;
  slam::Features features;
  for (std::size_t i = 0; i < std::min(most_frames, source.size()); ++i) {
    source.read(i, frame);
    slam::prepare_scan(frame, gate_of(source, options), scan);
    extractor.extract(scan, features);
    const auto keyframes = odometry.keyframes().size();
    odometry.add(i, scan.begin_time_s, scan.end_time_s, features, {});
    if (odometry.keyframes().size() > keyframes)
      odometry.set_context(slam::context_of(scan, odometry.frames().back().motion, slam::context_shape(options)));
    if (odometry.lost()) throw failure("the track was lost at frame " + std::to_string(i), odometry.why_failed());
    if (i % 500 == 0) std::fprintf(stderr, "frame %zu of %zu\n", i, source.size());
  }
  return odometry.take_keyframes();
}

std::vector<slam::Keyframe> true_keyframes(const FrameSource& source, const slam::SlamSettings& options,
                                           const Trajectory& truth, std::size_t most_frames) {
  slam::FeatureExtractor extractor(options);
  ScanFrame frame;
  slam::Scan scan;
  slam::Features features;
  std::vector<slam::Keyframe> out;
  for (std::size_t i = 0; i < std::min(most_frames, source.size()); ++i) {
    const Pose T = truth.at(source.frame_time_s(i));
    if (!out.empty()) {
      const Pose moved = out.back().T_map_keyframe.inverse() * T;
      if (moved.translation().norm() < options.keyframe_distance &&
          Eigen::AngleAxisd(moved.linear()).angle() < rad(options.keyframe_angle_deg))
        continue;
    }
    source.read(i, frame);
    slam::prepare_scan(frame, gate_of(source, options), scan);
    extractor.extract(scan, features);
    const slam::FrameMotion motion{truth.at(scan.begin_time_s), truth.at(scan.end_time_s)};
    const double distance =
        out.empty() ? 0 : (motion.T_map_end.translation() - out.back().T_map_keyframe.translation()).norm();
    const double travelled = out.empty() ? 0 : out.back().travelled + distance;
    out.push_back(slam::make_keyframe(out.size(), scan.end_time_s, features.map, motion));
    out.back().travelled = travelled;
    out.back().context = slam::context_of(scan, motion, slam::context_shape(options));
  }
  return out;
}

void add_drift(std::vector<slam::Keyframe>& keyframes, double share, unsigned seed) {
  constexpr double stretch_m = 20;
  const double per_stretch = share * std::sqrt(100 / stretch_m);
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  double slip = 0, turn_rad_m = 0, until_m = -1;
  Pose T_true_before = Pose::Identity(), T = Pose::Identity();
  for (std::size_t k = 0; k < keyframes.size(); ++k) {
    auto& pose = keyframes[k].T_map_keyframe;
    const Pose T_true = pose;
    if (k == 0) {
      T = T_true;
    } else {
      if (keyframes[k].travelled > until_m) {
        slip = per_stretch * normal(random);
        turn_rad_m = rad(1) * per_stretch * normal(random);
        until_m = keyframes[k].travelled + stretch_m;
      }
      Pose moved = T_true_before.inverse() * T_true;
      moved.translation() *= 1 + slip;
      // About the upright, so that the ground stays level.
      const double distance = moved.translation().norm();
      T = T * moved;
      T.linear() = Eigen::AngleAxisd(turn_rad_m * distance, Eigen::Vector3d::UnitZ()).toRotationMatrix() * T.linear();
    }
    T_true_before = T_true;
    pose = T;
  }
}

}  // namespace bole
