#include "slam/core/loops/loop_registration.h"

#include "slam/core/map/grid_key.h"
#include "slam/core/odometry/point_registration.h"

namespace bole::slam {
namespace {

constexpr double icp_reach_m = 1.0, ndt_cell_m = 1.0, point_spacing_m = 0.2;

std::vector<FeaturePoint> as_features(const std::vector<Eigen::Vector3f>& points, double spacing_m) {
  std::vector<FeaturePoint> out;
  out.reserve(points.size());
  for (const auto& p : points) out.push_back({p, 1});
  thin_on_grid(out, spacing_m);
  return out;
}

std::vector<Eigen::Vector3f> thinned(const std::vector<Eigen::Vector3f>& points, double spacing_m) {
  std::vector<Eigen::Vector3f> out;
  for (const auto& f : as_features(points, spacing_m)) out.push_back(f.position);
  return out;
}

}  // namespace

LoopTarget::LoopTarget(const std::vector<Keyframe>& keyframes, std::size_t first, std::size_t last,
                       const SlamOptions& options)
    : options_(options), maps_(options.cell_m), origin_(keyframes[first].T_map_keyframe.translation()) {
  for (std::size_t k = first; k <= last; ++k) {
    insert_keyframe(keyframes[k], maps_);
    if (options.loop_registration == "features") continue;
    for (const auto* part : {&keyframes[k].edges, &keyframes[k].planes})
      for (const auto& p : *part)
        points_.push_back((keyframes[k].T_map_keyframe * p.cast<double>() - origin_).cast<float>());
  }
  points_ = thinned(points_, point_spacing_m);
}

Registration LoopTarget::registered(const Keyframe& keyframe, const Pose& guess, const Run& run) const {
  RegistrationSettings settings;
  settings.sigma_m = options_.range_sigma_m;
  settings.kernel_sigmas = options_.kernel_sigmas;
  settings.rounds = 30, settings.coarse_rounds = 6;
  const FeatureSet features{as_features(keyframe.edges, options_.query_spacing_m),
                            as_features(keyframe.planes, options_.query_spacing_m)};
  if (options_.loop_registration == "features") return register_frame(features, maps_, {guess, guess}, settings, run);

  auto source = keyframe.edges;
  source.insert(source.end(), keyframe.planes.begin(), keyframe.planes.end());
  source = thinned(source, point_spacing_m);
  Pose T = guess;
  T.translation() -= origin_;
  if (options_.loop_registration == "ndt_icp") T = register_by_ndt(source, points_, T, ndt_cell_m).T_target_source;
  run.check_cancel();
  T = register_by_icp(source, points_, T, icp_reach_m).T_target_source;
  T.translation() += origin_;
  // One round tells how well the features agree there; its step is not taken.
  settings.rounds = 1, settings.coarse_rounds = 0;
  auto r = register_frame(features, maps_, {T, T}, settings, run);
  r.motion = {T, T};
  return r;
}

}  // namespace bole::slam
