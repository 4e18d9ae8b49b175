#include "slam/core/loops.h"

#include <algorithm>
#include <optional>

namespace bole {
namespace {

constexpr double trial_spacing_m = 1.5;  // way between key frames that are tried
constexpr std::size_t stretch_half = 8;  // key frames on each side of the partner that make its map
constexpr double least_conditioning = 1e-3;
constexpr double largest_correction_m = 2.0;

std::optional<std::size_t> partner_of(const std::vector<Keyframe>& keyframes, std::size_t k,
                                      const SlamOptions& options) {
  std::optional<std::size_t> best;
  double best_m = options.loop_radius_m;
  for (std::size_t j = 0; j < k; ++j) {
    if (keyframes[k].path_m - keyframes[j].path_m < options.loop_path_m) break;
    const double d = (keyframes[k].T_map_keyframe.translation() - keyframes[j].T_map_keyframe.translation()).norm();
    if (d < best_m) best = j, best_m = d;
  }
  return best;
}

FeatureSet thinned(const Keyframe& keyframe, double spacing_m) {
  FeatureSet out;
  for (const auto& p : keyframe.edges) out.edges.push_back({p, 1});
  for (const auto& p : keyframe.planes) out.planes.push_back({p, 1});
  thin_on_grid(out.edges, spacing_m);
  thin_on_grid(out.planes, spacing_m);
  return out;
}

std::optional<Loop> verified(const std::vector<Keyframe>& keyframes, std::size_t from, std::size_t to,
                             const SlamOptions& options, FeatureMaps& maps, const Run& run) {
  maps.clear();
  const std::size_t first = from > stretch_half ? from - stretch_half : 0,
                    last = std::min({from + stretch_half, keyframes.size() - 1, to - 1});
  for (std::size_t k = first; k <= last; ++k) insert_keyframe(keyframes[k], maps);

  RegistrationSettings settings;
  settings.rounds = 30;
  settings.coarse_rounds = 6;
  settings.sigma_m = options.range_sigma_m;
  settings.kernel_sigmas = options.kernel_sigmas;
  const Pose& guess = keyframes[to].T_map_keyframe;
  const auto r = register_frame(thinned(keyframes[to], options.query_spacing_m), maps, {guess, guess}, settings, run);
  const double correction_m = (r.motion.T_map_end.translation() - guess.translation()).norm();
  if (r.overlap < options.loop_overlap || r.conditioning < least_conditioning || correction_m > largest_correction_m)
    return std::nullopt;
  return Loop{from, to, keyframes[from].T_map_keyframe.inverse() * r.motion.T_map_end, r.information, r.overlap};
}

}  // namespace

LoopSearch find_loops(const std::vector<Keyframe>& keyframes, const SlamOptions& options, const Run& run) {
  LoopSearch out;
  FeatureMaps maps(options.cell_m);
  double last_trial_m = -trial_spacing_m;
  for (std::size_t k = 0; k < keyframes.size(); ++k) {
    if (keyframes[k].path_m - last_trial_m < trial_spacing_m) continue;
    const auto partner = partner_of(keyframes, k, options);
    if (!partner) continue;
    last_trial_m = keyframes[k].path_m;
    ++out.candidates;
    if (auto loop = verified(keyframes, *partner, k, options, maps, run)) out.loops.push_back(*loop);
    run.report(static_cast<double>(k) / static_cast<double>(keyframes.size()), "loops");
    if (run.asked_to_finish()) break;
  }
  return out;
}

}  // namespace bole
