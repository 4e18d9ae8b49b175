#include "slam/core/loops/loop_candidates.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "slam/core/loops/context_index.h"
#include "slam/core/loops/place_guess.h"

namespace bole::slam {
namespace {

constexpr double trial_spacing_m = 1.5;       // way between key frames that are tried
constexpr double largest_correction_m = 2.0;  // of what the odometry puts near
constexpr std::size_t stretch_half = 8;       // key frames on each side of the partner that make its map
constexpr std::size_t context_places = 3;     // that look alike and are tried
constexpr double context_apart_m = 1.5;
constexpr double context_offset_m = 3.0;                // of a place that looks alike
constexpr double most_turn_rad = std::numbers::pi / 6;  // that the odometry may have drifted by
// The key frames before: so many, so far apart, held against key frames of the stretch that lie so near.
constexpr std::size_t sequence_length = 5;
constexpr double sequence_step_m = 1.5, sequence_reach_m = 1.0;
// Looks scatter by about so much about the same place; the offset that is allowed counts as three standard deviations.
constexpr double look_sigma = 0.05, offset_sigmas = 3;
constexpr std::size_t most_sequences = 60;  // places whose stretch is compared

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

std::optional<LoopCandidate> by_odometry(const std::vector<Keyframe>& keyframes, std::size_t k,
                                         const SlamOptions& options) {
  const auto partner = partner_of(keyframes, k, options);
  if (!partner) return std::nullopt;
  return LoopCandidate{*partner, k, keyframes[k].T_map_keyframe, largest_correction_m, "odometry"};
}

double most_offset_m(const std::vector<Keyframe>& keyframes, std::size_t from, std::size_t to,
                     const SlamOptions& options) {
  return context_offset_m + options.loop_drift * (keyframes[to].path_m - keyframes[from].path_m);
}

// The key frame and those before it, a step apart.
std::vector<std::size_t> sequence_of(const std::vector<Keyframe>& keyframes, std::size_t k) {
  std::vector<std::size_t> out{k};
  for (std::size_t i = k; i-- > 0 && out.size() < sequence_length;)
    if (keyframes[out.back()].path_m - keyframes[i].path_m >= sequence_step_m) out.push_back(i);
  return out;
}

Pose turned(const Pose& T_map_level, double turn_rad) {
  Pose T = T_map_level;
  T.linear() = T.linear() * Eigen::AngleAxisd(turn_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return T;
}

// Compares key frame `k` and those before it with earlier places. Levelled axes throughout.
class SequenceSearch {
 public:
  SequenceSearch(const std::vector<Keyframe>& keyframes, std::size_t k, const SlamOptions& options)
      : keyframes_(keyframes),
        options_(options),
        T_map_k_(levelled(keyframes[k].T_map_keyframe)),
        sequence_(sequence_of(keyframes, k)) {
    for (const auto s : sequence_) T_k_before_.push_back(T_map_k_.inverse() * levelled(keyframes[s].T_map_keyframe));
  }

  // The place and heading of key frame `j` as one that the odometry allows; nothing where it does not look alike. The
  // distance is that of the looks, and what it costs to have drifted there.
  std::optional<ContextCandidate> at(std::size_t j) const {
    const auto k = sequence_.front();
    const Pose T_map_j = levelled(keyframes_[j].T_map_keyframe);
    const double sigmas = offset_sigmas * (T_map_j.translation() - T_map_k_.translation()).norm() /
                          most_offset_m(keyframes_, j, k, options_);
    if (sigmas > offset_sigmas) return std::nullopt;
    const auto own = match(j, k, T_map_k_, static_cast<int>(std::lround(most_turn_rad / sector_rad())));
    if (own.distance >= options_.context_tau) return std::nullopt;
    return ContextCandidate{j, own.distance + 0.5 * look_sigma * sigmas * sigmas,
                            turned(Pose::Identity(), own.shift * sector_rad())};
  }

  // The mean over the way before, each key frame held against the place where it would have been.
  double distance(const ContextCandidate& c) const {
    const Pose T_map_k = levelled(keyframes_[c.keyframe].T_map_keyframe) * c.T_from_to;
    double sum = c.distance;
    std::size_t n = 1;
    for (std::size_t s = 1; s < sequence_.size(); ++s) {
      const Pose T_map_before = T_map_k * T_k_before_[s];
      const auto i = nearest_to(c.keyframe, T_map_before.translation());
      if (!i) continue;
      sum += match(*i, sequence_[s], T_map_before, 1).distance, ++n;
    }
    return sum / static_cast<double>(n);
  }

 private:
  double sector_rad() const { return 2 * std::numbers::pi / options_.context_sectors; }

  // Key frame `b`, thought to be at T_map_b, seen from `a`.
  ContextMatch match(std::size_t a, std::size_t b, const Pose& T_map_b, int most_sectors) const {
    if (keyframes_[a].context.empty() || keyframes_[b].context.empty()) return {1, 0};
    const Eigen::Matrix3d R = levelled(keyframes_[a].T_map_keyframe).linear().transpose() * T_map_b.linear();
    const auto expected = static_cast<int>(std::lround(std::atan2(R(1, 0), R(0, 0)) / sector_rad()));
    return match_polar(keyframes_[a].context, keyframes_[b].context, expected - most_sectors, expected + most_sectors);
  }

  // On the stretch about key frame `j`.
  std::optional<std::size_t> nearest_to(std::size_t j, const Eigen::Vector3d& place) const {
    const double reach_m = sequence_reach_m + sequence_length * sequence_step_m;
    std::optional<std::size_t> best;
    double best_m = sequence_reach_m;
    const auto ask = [&](std::size_t i) {
      const double d = (keyframes_[i].T_map_keyframe.translation() - place).head<2>().norm();
      if (d < best_m) best = i, best_m = d;
    };
    for (std::size_t i = j; i < keyframes_.size() && keyframes_[i].path_m - keyframes_[j].path_m < reach_m; ++i) ask(i);
    for (std::size_t i = j; i-- > 0 && keyframes_[j].path_m - keyframes_[i].path_m < reach_m;) ask(i);
    return best;
  }

  const std::vector<Keyframe>& keyframes_;
  const SlamOptions& options_;
  Pose T_map_k_;
  std::vector<std::size_t> sequence_;
  std::vector<Pose> T_k_before_;
};

std::vector<ContextCandidate> ranked_by_sequence(const std::vector<Keyframe>& keyframes, std::size_t indexed,
                                                 std::size_t k, const SlamOptions& options) {
  const SequenceSearch search(keyframes, k, options);
  std::vector<ContextCandidate> found;
  for (std::size_t j = 0; j < indexed; ++j)
    if (auto c = search.at(j)) found.push_back(std::move(*c));
  std::ranges::stable_sort(found, {}, &ContextCandidate::distance);
  found.resize(std::min(found.size(), most_sequences));
  for (auto& c : found) c.distance = search.distance(c);
  return most_alike(keyframes, std::move(found), context_places, context_apart_m);
}

std::optional<LoopCandidate> by_context(const std::vector<Keyframe>& keyframes, const ContextIndex& index,
                                        std::size_t indexed, std::size_t k, const SlamOptions& options) {
  const bool single = options.context_search == "single", sequence = options.context_search == "sequence";
  const Pose& T_map_k = keyframes[k].T_map_keyframe;
  const Pose T_level_k = levelled(T_map_k).inverse() * T_map_k;
  const ContextSearch settings{options.context_candidates, options.context_tau, options.loops == "both"};
  std::optional<LoopCandidate> best;
  double best_score = -1;
  for (const auto& found : sequence
                               ? ranked_by_sequence(keyframes, indexed, k, options)
                               : index.ranked(keyframes, k, settings, single ? 1 : context_places, context_apart_m)) {
    const Pose T_map_to = levelled(keyframes[found.keyframe].T_map_keyframe) * found.T_from_to * T_level_k;
    const double most_m = most_offset_m(keyframes, found.keyframe, k, options);
    if ((T_map_to.translation() - T_map_k.translation()).norm() > most_m) continue;
    if (single) return LoopCandidate{found.keyframe, k, T_map_to, most_m, "context"};
    const auto [first, last] = stretch_about(keyframes, found.keyframe, k);
    const auto placed = place_on_stretch(keyframes, first, last, keyframes[k], T_map_to);
    if (placed.score <= best_score) continue;
    best_score = placed.score;
    best = LoopCandidate{found.keyframe, k, placed.T_map_keyframe, most_m, "context"};
  }
  return best;
}

}  // namespace

std::pair<std::size_t, std::size_t> stretch_about(const std::vector<Keyframe>& keyframes, std::size_t from,
                                                  std::size_t to) {
  return {from > stretch_half ? from - stretch_half : 0, std::min({from + stretch_half, keyframes.size() - 1, to - 1})};
}

std::vector<LoopCandidate> find_loop_candidates(const std::vector<Keyframe>& keyframes, const SlamOptions& options,
                                                const Run& run) {
  std::vector<LoopCandidate> out;
  const bool near = options.loops != "context", alike = options.loops == "context" || options.loops == "both";
  ContextIndex index(context_shape(options));
  std::size_t indexed = 0;
  double last_trial_m = -trial_spacing_m;
  for (std::size_t k = 0; k < keyframes.size() && !run.asked_to_finish(); ++k) {
    run.check_cancel();
    while (alike && keyframes[k].path_m - keyframes[indexed].path_m >= options.loop_path_m)
      index.add(keyframes, indexed++);
    if (keyframes[k].path_m - last_trial_m < trial_spacing_m) continue;
    const auto before = out.size();
    if (near)
      if (auto c = by_odometry(keyframes, k, options)) out.push_back(std::move(*c));
    if (alike)
      if (auto c = by_context(keyframes, index, indexed, k, options)) out.push_back(std::move(*c));
    if (out.size() > before) last_trial_m = keyframes[k].path_m;
    run.report(static_cast<double>(k) / static_cast<double>(keyframes.size()), "looking for loops");
  }
  return out;
}

}  // namespace bole::slam
