#include "slam/core/loops/loop_registration.h"

#include "slam/core/map/grid_key.h"
#include "slam/core/odometry/point_registration.h"

namespace bole::slam {
namespace {

constexpr double icp_reach = 1.0, ndt_cell_size = 1.0, point_spacing = 0.2;

std::vector<FeaturePoint> as_features(const std::vector<Eigen::Vector3f>& points, double spacing) {
  std::vector<FeaturePoint> out;
  out.reserve(points.size());
  for (const auto& p : points) out.push_back({p, 1});
  thin_on_grid(out, spacing);
  return out;
}

std::vector<Eigen::Vector3f> thinned(const std::vector<Eigen::Vector3f>& points, double spacing) {
  std::vector<Eigen::Vector3f> out;
  for (const auto& f : as_features(points, spacing)) out.push_back(f.position);
  return out;
}

}  // namespace

LoopTarget::LoopTarget(const std::vector<Keyframe>& keyframes, std::size_t first, std::size_t last,
                       const SlamSettings& settings)
    : settings_(settings), maps_(settings.cell_size), origin_(keyframes[first].T_map_keyframe.translation()) {
  for (std::size_t k = first; k <= last; ++k) {
    insert_keyframe(keyframes[k], maps_);
    if (settings.loop_registration == LoopRegistrationKind::features) continue;
    for (const auto* part : {&keyframes[k].edges, &keyframes[k].planes})
      for (const auto& p : *part)
        points_.push_back((keyframes[k].T_map_keyframe * p.cast<double>() - origin_).cast<float>());
  }
  points_ = thinned(points_, point_spacing);
}

LoopRegistration LoopTarget::registered(const Keyframe& keyframe, const Pose& guess, const Run& run) const {
  RegistrationSettings registration;
  registration.sigma = settings_.range_sigma;
  registration.kernel_sigmas = settings_.kernel_sigmas;
  registration.iterations = 30;
  registration.coarse_iterations = 6;
  const FeatureSet features{as_features(keyframe.edges, settings_.query_spacing),
                            as_features(keyframe.planes, settings_.query_spacing)};
  if (settings_.loop_registration == LoopRegistrationKind::features) {
    auto r = register_frame(features, maps_, {guess, guess}, registration, run);
    return {r, r.converged, r.rms};
  }

  auto source = keyframe.edges;
  source.insert(source.end(), keyframe.planes.begin(), keyframe.planes.end());
  source = thinned(source, point_spacing);
  Pose T = guess;
  T.translation() -= origin_;
  if (settings_.loop_registration == LoopRegistrationKind::ndt_icp)
    T = register_by_ndt(source, points_, T, ndt_cell_size).T_target_source;
  run.check_cancel();
  const auto icp = register_by_icp(source, points_, T, icp_reach);
  T = icp.T_target_source;
  T.translation() += origin_;
  // One iteration measures how well the features agree there; its step is not taken.
  registration.iterations = 1;
  registration.coarse_iterations = 0;
  auto r = register_frame(features, maps_, {T, T}, registration, run);
  r.motion = {T, T};
  return {r, icp.converged, icp.rms};
}

}  // namespace bole::slam
