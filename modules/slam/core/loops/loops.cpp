#include "slam/core/loops/loops.h"

#include <optional>

#include "slam/core/loops/loop_candidates.h"
#include "slam/core/loops/loop_registration.h"
#include "slam/core/slam_preview.h"

namespace bole::slam {
namespace {

constexpr double min_conditioning = 1e-3;
// Possible error of a registration: a place this close to the radius may lie outside it.
constexpr double place_error = 0.1;

std::optional<Loop> verified(const std::vector<Keyframe>& keyframes, const LoopCandidate& c,
                             const SlamSettings& settings, const Run& run) {
  const auto [first, last] = stretch_about(keyframes, c.from, c.to);
  const LoopTarget target(keyframes, first, last, settings);
  const auto r = target.registered(keyframes[c.to], c.T_map_to, run);
  const Pose& T_odometry = keyframes[c.to].T_map_keyframe;
  const double correction = (r.motion.T_map_end.translation() - T_odometry.translation()).norm();
  if (r.overlap < settings.loop_overlap || r.conditioning < min_conditioning || correction > c.max_correction)
    return std::nullopt;
  // However similar: where registration puts it farther away, it is another place.
  if ((keyframes[c.from].T_map_keyframe.translation() - r.motion.T_map_end.translation()).norm() >
      settings.loop_radius - place_error)
    return std::nullopt;
  return Loop{c.from,        c.to,      keyframes[c.from].T_map_keyframe.inverse() * r.motion.T_map_end,
              r.information, r.overlap, correction,
              c.found_by};
}

}  // namespace

LoopSearch find_loops(const std::vector<Keyframe>& keyframes, const SlamSettings& settings, const Run& run) {
  const auto candidates = find_loop_candidates(keyframes, settings, run.part(0, 0.3));
  const Run verifying = run.part(0.3, 1);
  LoopSearch out;
  for (const auto& c : candidates) {
    if (run.asked_to_finish()) break;
    verifying.report(static_cast<double>(out.candidates) / static_cast<double>(candidates.size()), "closing loops");
    ++out.candidates;
    if (auto loop = verified(keyframes, c, settings, verifying))
      out.loops.push_back(std::move(*loop));
    else
      out.refused.emplace_back(c.from, c.to);
    preview_loops(run, out.loops, out.refused, false);
  }
  return out;
}

}  // namespace bole::slam
