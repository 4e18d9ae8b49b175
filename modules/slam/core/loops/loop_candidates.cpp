#include "slam/core/loops/loop_candidates.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "slam/core/loops/context_index.h"
#include "slam/core/loops/place_guess.h"

namespace bole::slam {
namespace {

constexpr double trial_spacing = 1.5;            // distance travelled between keyframes that are tried
constexpr double max_odometry_correction = 2.0;  // for candidates by odometry
constexpr std::size_t context_places = 3;        // most similar places that are tried
constexpr double context_spacing = 1.5;
constexpr double context_offset = 3.0;                 // of a candidate by context, without drift
constexpr double max_turn_rad = std::numbers::pi / 6;  // largest drift of the heading
// Number and spacing of the keyframes before, and how near a keyframe of the stretch must be to be compared.
constexpr std::size_t sequence_length = 5;
constexpr double sequence_step = 1.5, sequence_reach = 1.0;
// Context distances of the same place scatter by about this much. The permitted offset counts as three standard
// deviations.
constexpr double look_sigma = 0.05, offset_sigmas = 3;
constexpr std::size_t max_sequences = 60;  // places whose sequence is compared

std::optional<std::size_t> partner_of(const std::vector<Keyframe>& keyframes, std::size_t k,
                                      const SlamSettings& settings) {
  std::optional<std::size_t> best;
  double best_distance = settings.loop_radius;
  for (std::size_t j = 0; j < k; ++j) {
    if (keyframes[k].travelled - keyframes[j].travelled < settings.loop_path) break;
    const double d = (keyframes[k].T_map_keyframe.translation() - keyframes[j].T_map_keyframe.translation()).norm();
    if (d < best_distance) {
      best = j;
      best_distance = d;
    }
  }
  return best;
}

std::optional<LoopCandidate> by_odometry(const std::vector<Keyframe>& keyframes, std::size_t k,
                                         const SlamSettings& settings) {
  const auto partner = partner_of(keyframes, k, settings);
  if (!partner) return std::nullopt;
  const auto& T_map_k = keyframes[k].T_map_keyframe;
  return LoopCandidate{
      *partner,          k,
      T_map_k,           max_odometry_correction,
      FoundBy::odometry, (keyframes[*partner].T_map_keyframe.translation() - T_map_k.translation()).norm()};
}

double max_offset(const std::vector<Keyframe>& keyframes, std::size_t from, std::size_t to,
                  const SlamSettings& settings) {
  return context_offset + settings.loop_drift * (keyframes[to].travelled - keyframes[from].travelled);
}

// The keyframe and those before it, one step apart.
std::vector<std::size_t> sequence_of(const std::vector<Keyframe>& keyframes, std::size_t k) {
  std::vector<std::size_t> out{k};
  for (std::size_t i = k; i-- > 0 && out.size() < sequence_length;)
    if (keyframes[out.back()].travelled - keyframes[i].travelled >= sequence_step) out.push_back(i);
  return out;
}

Pose turned(const Pose& T_map_level, double turn_rad) {
  Pose T = T_map_level;
  T.linear() = T.linear() * Eigen::AngleAxisd(turn_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return T;
}

// Compares keyframe `k` and those before it with earlier places. All axes are levelled.
class SequenceSearch {
 public:
  SequenceSearch(const std::vector<Keyframe>& keyframes, std::size_t k, const SlamSettings& settings)
      : keyframes_(keyframes),
        settings_(settings),
        T_map_k_(levelled(keyframes[k].T_map_keyframe)),
        sequence_(sequence_of(keyframes, k)) {
    for (const auto s : sequence_) T_k_before_.push_back(T_map_k_.inverse() * levelled(keyframes[s].T_map_keyframe));
  }

  // The pose at keyframe `j`, if the odometry allows it and the contexts are similar. The distance is that of the
  // contexts plus a penalty for the drift.
  std::optional<ContextCandidate> at(std::size_t j) const {
    const auto k = sequence_.front();
    const Pose T_map_j = levelled(keyframes_[j].T_map_keyframe);
    const double sigmas = offset_sigmas * (T_map_j.translation() - T_map_k_.translation()).norm() /
                          max_offset(keyframes_, j, k, settings_);
    if (sigmas > offset_sigmas) return std::nullopt;
    const auto own = match(j, k, T_map_k_, static_cast<int>(std::lround(max_turn_rad / sector_rad())));
    if (own.distance >= settings_.context_tau) return std::nullopt;
    return ContextCandidate{j, own.distance + 0.5 * look_sigma * sigmas * sigmas,
                            turned(Pose::Identity(), own.shift * sector_rad())};
  }

  // The mean distance over the keyframes before, each compared with the place where it would have been.
  double distance(const ContextCandidate& c) const {
    const Pose T_map_k = levelled(keyframes_[c.keyframe].T_map_keyframe) * c.T_from_to;
    double sum = c.distance;
    std::size_t n = 1;
    for (std::size_t s = 1; s < sequence_.size(); ++s) {
      const Pose T_map_before = T_map_k * T_k_before_[s];
      const auto i = nearest_to(c.keyframe, T_map_before.translation());
      if (!i) continue;
      sum += match(*i, sequence_[s], T_map_before, 1).distance;
      ++n;
    }
    return sum / static_cast<double>(n);
  }

 private:
  double sector_rad() const { return 2 * std::numbers::pi / settings_.context_sectors; }

  // Keyframe `b`, assumed at T_map_b, seen from `a`.
  ContextMatch match(std::size_t a, std::size_t b, const Pose& T_map_b, int max_sectors) const {
    if (keyframes_[a].context.empty() || keyframes_[b].context.empty()) return {1, 0};
    const Eigen::Matrix3d R = levelled(keyframes_[a].T_map_keyframe).linear().transpose() * T_map_b.linear();
    const auto expected = static_cast<int>(std::lround(std::atan2(R(1, 0), R(0, 0)) / sector_rad()));
    return match_polar(keyframes_[a].context, keyframes_[b].context, expected - max_sectors, expected + max_sectors,
                       settings_.context_distance);
  }

  // Among the keyframes around `j`.
  std::optional<std::size_t> nearest_to(std::size_t j, const Eigen::Vector3d& place) const {
    const double reach = sequence_reach + sequence_length * sequence_step;
    std::optional<std::size_t> best;
    double best_distance = sequence_reach;
    const auto consider = [&](std::size_t i) {
      const double d = (keyframes_[i].T_map_keyframe.translation() - place).head<2>().norm();
      if (d < best_distance) {
        best = i;
        best_distance = d;
      }
    };
    for (std::size_t i = j; i < keyframes_.size() && keyframes_[i].travelled - keyframes_[j].travelled < reach; ++i)
      consider(i);
    for (std::size_t i = j; i-- > 0 && keyframes_[j].travelled - keyframes_[i].travelled < reach;) consider(i);
    return best;
  }

  const std::vector<Keyframe>& keyframes_;
  const SlamSettings& settings_;
  Pose T_map_k_;
  std::vector<std::size_t> sequence_;
  std::vector<Pose> T_k_before_;
};

std::vector<ContextCandidate> ranked_by_sequence(const std::vector<Keyframe>& keyframes, std::size_t indexed,
                                                 std::size_t k, const SlamSettings& settings) {
  const SequenceSearch search(keyframes, k, settings);
  std::vector<ContextCandidate> found;
  for (std::size_t j = 0; j < indexed; ++j)
    if (auto c = search.at(j)) found.push_back(std::move(*c));
  std::ranges::stable_sort(found, {}, &ContextCandidate::distance);
  found.resize(std::min(found.size(), max_sequences));
  for (auto& c : found) c.distance = search.distance(c);
  return closest(keyframes, std::move(found), context_places, context_spacing);
}

std::optional<LoopCandidate> by_context(const std::vector<Keyframe>& keyframes, const ContextIndex& index,
                                        std::size_t indexed, std::size_t k, const SlamSettings& settings) {
  const bool single = settings.context_search == ContextSearchKind::single,
             sequence = settings.context_search == ContextSearchKind::sequence;
  const Pose& T_map_k = keyframes[k].T_map_keyframe;
  const Pose T_level_k = levelled(T_map_k).inverse() * T_map_k;
  const ContextSearch search{settings.context_candidates, settings.context_tau, settings.loops == LoopSource::both,
                             settings.context_distance};
  const bool gated = !single || settings.loop_acceptance == LoopAcceptance::overlap;
  std::optional<LoopCandidate> best;
  double best_score = -1;
  for (const auto& found : sequence
                               ? ranked_by_sequence(keyframes, indexed, k, settings)
                               : index.ranked(keyframes, k, search, single ? 1 : context_places, context_spacing)) {
    const Pose T_map_to = levelled(keyframes[found.keyframe].T_map_keyframe) * found.T_from_to * T_level_k;
    const double max_correction = max_offset(keyframes, found.keyframe, k, settings);
    if (gated && (T_map_to.translation() - T_map_k.translation()).norm() > max_correction) continue;
    if (single) return LoopCandidate{found.keyframe, k, T_map_to, max_correction, FoundBy::context, found.distance};
    const auto [first, last] = stretch_about(keyframes, found.keyframe, k, settings);
    const auto placed = place_on_stretch(keyframes, first, last, keyframes[k], T_map_to);
    if (placed.score <= best_score) continue;
    best_score = placed.score;
    best = LoopCandidate{found.keyframe, k, placed.T_map_keyframe, max_correction, FoundBy::context, found.distance};
  }
  return best;
}

}  // namespace

std::pair<std::size_t, std::size_t> stretch_about(const std::vector<Keyframe>& keyframes, std::size_t from,
                                                  std::size_t to, const SlamSettings& settings) {
  const auto half = static_cast<std::size_t>(settings.loop_stretch);
  return {from > half ? from - half : 0, std::min({from + half, keyframes.size() - 1, to - 1})};
}

std::vector<LoopCandidate> find_loop_candidates(const std::vector<Keyframe>& keyframes, const SlamSettings& settings,
                                                const Run& run) {
  std::vector<LoopCandidate> out;
  const bool near = uses_odometry(settings.loops), alike = uses_context(settings.loops);
  ContextIndex index(context_shape(settings));
  std::size_t indexed = 0;
  double last_trial = -trial_spacing;
  for (std::size_t k = 0; k < keyframes.size() && !run.asked_to_finish(); ++k) {
    run.check_cancel();
    while (alike && keyframes[k].travelled - keyframes[indexed].travelled >= settings.loop_path)
      index.add(keyframes, indexed++);
    if (keyframes[k].travelled - last_trial < trial_spacing) continue;
    const auto before = out.size();
    if (near)
      if (auto c = by_odometry(keyframes, k, settings)) out.push_back(std::move(*c));
    if (alike)
      if (auto c = by_context(keyframes, index, indexed, k, settings)) out.push_back(std::move(*c));
    if (out.size() > before) last_trial = keyframes[k].travelled;
    run.report(static_cast<double>(k) / static_cast<double>(keyframes.size()), "looking for loops");
  }
  return out;
}

}  // namespace bole::slam
