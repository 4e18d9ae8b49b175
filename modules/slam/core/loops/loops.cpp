#include "slam/core/loops/loops.h"

#include <cmath>

#include "slam/core/loops/loop_candidates.h"
#include "slam/core/loops/loop_registration.h"
#include "slam/core/slam_preview.h"

namespace bole::slam {
namespace {

constexpr double min_conditioning = 1e-3;
// Possible error of a registration: a place this close to the radius may lie outside it.
constexpr double place_error = 0.1;

std::string rounded(double value) { return number_text(std::round(100 * value) / 100); }

std::string percent(double share) { return number_text(std::round(100 * share)) + " %"; }

// Why the overlap, the odometry or the place speak against a candidate; empty where they do not.
std::string objection(const Keyframe& from, const LoopCandidate& c, const Registration& r, double correction,
                      const SlamSettings& settings) {
  if (r.overlap < settings.loop_overlap)
    return "only " + percent(r.overlap) + " of the points agree; loop_overlap is " + percent(settings.loop_overlap);
  if (r.conditioning < min_conditioning) return "the surroundings leave a direction open";
  if (correction > c.max_correction)
    return "it would move the odometry by " + rounded(correction) + " m; at most " + rounded(c.max_correction) +
           " m are expected here";
  // However similar: where registration puts it farther away, it is another place.
  const double apart = (from.T_map_keyframe.translation() - r.motion.T_map_end.translation()).norm();
  if (apart > settings.loop_radius - place_error)
    return "the places are " + rounded(apart) + " m apart; at most " + rounded(settings.loop_radius - place_error) +
           " m are allowed (loop_radius)";
  return {};
}

std::string objection_by_distance(const LoopRegistration& r, const SlamSettings& settings) {
  if (!r.converged) return "the registration does not converge";
  if (r.closest_rms > settings.loop_fitness)
    return "the closest points are " + rounded(r.closest_rms) + " m apart; loop_fitness is " +
           rounded(settings.loop_fitness) + " m";
  return {};
}

CheckedLoop checked(const std::vector<Keyframe>& keyframes, const LoopCandidate& c, const SlamSettings& settings,
                    const Run& run) {
  const auto [first, last] = stretch_about(keyframes, c.from, c.to, settings);
  const LoopTarget target(keyframes, first, last, settings);
  const auto found = target.registered(keyframes[c.to], c.T_map_to, run);
  const Registration& r = found.registration;
  const auto& from = keyframes[c.from];
  const Pose& T_odometry = keyframes[c.to].T_map_keyframe;
  const double correction = (r.motion.T_map_end.translation() - T_odometry.translation()).norm();
  CheckedLoop out;
  out.loop = {c.from,     c.to,      from.T_map_keyframe.inverse() * r.motion.T_map_end, r.information, r.overlap,
              correction, c.found_by};
  out.reason = settings.loop_acceptance == LoopAcceptance::distance ? objection_by_distance(found, settings)
                                                                    : objection(from, c, r, correction, settings);
  out.accepted = out.reason.empty();
  out.score = c.score;
  out.rms = r.rms;
  out.conditioning = r.conditioning;
  return out;
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
    out.checked.push_back(checked(keyframes, c, settings, verifying));
    if (out.checked.back().accepted)
      out.loops.push_back(out.checked.back().loop);
    else
      out.refused.emplace_back(c.from, c.to);
    preview_loops(run, out.loops, out.refused, false);
  }
  return out;
}

}  // namespace bole::slam
