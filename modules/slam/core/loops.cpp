#include "slam/core/loops.h"

#include <algorithm>
#include <optional>

#include "slam/core/context_index.h"
#include "slam/core/loop_registration.h"
#include "slam/core/place_guess.h"
#include "slam/core/slam_preview.h"

namespace bole {
namespace {

constexpr double trial_spacing_m = 1.5;  // way between key frames that are tried
constexpr std::size_t stretch_half = 8;  // key frames on each side of the partner that make its map
constexpr double least_conditioning = 1e-3;
constexpr double largest_correction_m = 2.0;
constexpr std::size_t context_places = 3;  // that look alike and are tried
constexpr double context_apart_m = 1.5;
constexpr double context_offset_m = 3.0;  // of a place that looks alike

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

// A key frame, and where a revisit would put it.
struct Candidate {
  std::size_t from = 0, to = 0;
  Pose T_map_to = Pose::Identity();
  double most_correction_m = 0;
  std::string found_by;
};

// First and last key frame of the stretch about `from` that `to` is held against.
std::pair<std::size_t, std::size_t> stretch_about(const std::vector<Keyframe>& keyframes, std::size_t from,
                                                  std::size_t to) {
  return {from > stretch_half ? from - stretch_half : 0, std::min({from + stretch_half, keyframes.size() - 1, to - 1})};
}

std::optional<Loop> verified(const std::vector<Keyframe>& keyframes, const Candidate& c, const SlamOptions& options,
                             const Run& run) {
  const auto [first, last] = stretch_about(keyframes, c.from, c.to);
  const LoopTarget target(keyframes, first, last, options);
  const auto r = target.registered(keyframes[c.to], c.T_map_to, run);
  const Pose& T_odometry = keyframes[c.to].T_map_keyframe;
  const double correction_m = (r.motion.T_map_end.translation() - T_odometry.translation()).norm();
  if (r.overlap < options.loop_overlap || r.conditioning < least_conditioning || correction_m > c.most_correction_m)
    return std::nullopt;
  // Whatever it looked like: what registration puts farther off is another place.
  if ((keyframes[c.from].T_map_keyframe.translation() - r.motion.T_map_end.translation()).norm() >
      options.loop_radius_m)
    return std::nullopt;
  return Loop{c.from,        c.to,      keyframes[c.from].T_map_keyframe.inverse() * r.motion.T_map_end,
              r.information, r.overlap, correction_m,
              c.found_by};
}

std::optional<Candidate> by_odometry(const std::vector<Keyframe>& keyframes, std::size_t k,
                                     const SlamOptions& options) {
  const auto partner = partner_of(keyframes, k, options);
  if (!partner) return std::nullopt;
  return Candidate{*partner, k, keyframes[k].T_map_keyframe, largest_correction_m, "odometry"};
}

std::optional<Candidate> by_context(const std::vector<Keyframe>& keyframes, const ContextIndex& index, std::size_t k,
                                    const SlamOptions& options) {
  const Pose& T_map_k = keyframes[k].T_map_keyframe;
  const Pose T_level_k = levelled(T_map_k).inverse() * T_map_k;
  std::optional<Candidate> best;
  double best_score = -1;
  for (const auto& found :
       index.ranked(keyframes, k, {options.context_candidates, options.context_tau, options.loops == "both"},
                    context_places, context_apart_m)) {
    const Pose T_map_to = levelled(keyframes[found.keyframe].T_map_keyframe) * found.T_from_to * T_level_k;
    const double way_m = keyframes[k].path_m - keyframes[found.keyframe].path_m,
                 most_m = context_offset_m + options.loop_drift * way_m;
    if ((T_map_to.translation() - T_map_k.translation()).norm() > most_m) continue;
    const auto [first, last] = stretch_about(keyframes, found.keyframe, k);
    const auto placed = place_on_stretch(keyframes, first, last, keyframes[k], T_map_to);
    if (placed.score <= best_score) continue;
    best_score = placed.score;
    best = Candidate{found.keyframe, k, placed.T_map_keyframe, most_m, "context"};
  }
  return best;
}

}  // namespace

LoopSearch find_loops(const std::vector<Keyframe>& keyframes, const SlamOptions& options, const Run& run) {
  LoopSearch out;
  const bool near = options.loops != "context", alike = options.loops == "context" || options.loops == "both";
  ContextIndex index(context_shape(options));
  std::size_t indexed = 0;
  double last_trial_m = -trial_spacing_m;
  for (std::size_t k = 0; k < keyframes.size() && !run.asked_to_finish(); ++k) {
    while (alike && keyframes[k].path_m - keyframes[indexed].path_m >= options.loop_path_m)
      index.add(keyframes, indexed++);
    if (keyframes[k].path_m - last_trial_m < trial_spacing_m) continue;
    std::vector<Candidate> candidates;
    if (near)
      if (auto c = by_odometry(keyframes, k, options)) candidates.push_back(std::move(*c));
    if (alike)
      if (auto c = by_context(keyframes, index, k, options)) candidates.push_back(std::move(*c));
    if (candidates.empty()) continue;
    last_trial_m = keyframes[k].path_m;
    for (const auto& c : candidates) {
      ++out.candidates;
      if (auto loop = verified(keyframes, c, options, run))
        out.loops.push_back(std::move(*loop));
      else
        out.refused.emplace_back(c.from, c.to);
    }
    preview_loops(run, out.loops, out.refused, false);
    run.report(static_cast<double>(k) / static_cast<double>(keyframes.size()), "loops");
  }
  return out;
}

}  // namespace bole
