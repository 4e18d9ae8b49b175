#include "slam/core/loops/loops.h"

#include <optional>

#include "slam/core/loops/loop_candidates.h"
#include "slam/core/loops/loop_registration.h"
#include "slam/core/slam_preview.h"

namespace bole::slam {
namespace {

constexpr double least_conditioning = 1e-3;
// What a registration may be wrong by: a place that close to the radius could as well lie outside it.
constexpr double place_error_m = 0.1;

std::optional<Loop> verified(const std::vector<Keyframe>& keyframes, const LoopCandidate& c, const SlamOptions& options,
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
      options.loop_radius_m - place_error_m)
    return std::nullopt;
  return Loop{c.from,        c.to,      keyframes[c.from].T_map_keyframe.inverse() * r.motion.T_map_end,
              r.information, r.overlap, correction_m,
              c.found_by};
}

}  // namespace

LoopSearch find_loops(const std::vector<Keyframe>& keyframes, const SlamOptions& options, const Run& run) {
  const auto candidates = find_loop_candidates(keyframes, options, run.part(0, 0.3));
  const Run verifying = run.part(0.3, 1);
  LoopSearch out;
  for (const auto& c : candidates) {
    if (run.asked_to_finish()) break;
    verifying.report(static_cast<double>(out.candidates) / static_cast<double>(candidates.size()), "closing loops");
    ++out.candidates;
    if (auto loop = verified(keyframes, c, options, verifying))
      out.loops.push_back(std::move(*loop));
    else
      out.refused.emplace_back(c.from, c.to);
    preview_loops(run, out.loops, out.refused, false);
  }
  return out;
}

}  // namespace bole::slam
