#include "rgbd/core/matching/match_pair.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "base/statistics.h"
#include "rgbd/core/matching/gms.h"
#include "rgbd/core/matching/ray_motion.h"
#include "rgbd/core/matching/rigid_motion.h"

namespace bole::rgbd {
namespace {

constexpr double still_px = 1.5;  // in an image 1280 wide
constexpr double reference_width = 1280;
constexpr double min_moving_px = 3;  // median, below it the moving part is still as well
constexpr double min_second_share = 0.1;
constexpr std::size_t min_for_statistics = 60;  // of fewer matches the neighbours say nothing

class Screening {
 public:
  Screening(const MatchableView& a, const MatchableView& b, const ScreenOptions& options)
      : a_(a), b_(b), o_(options), still_px_(still_px * std::max(1.0, a.camera->width / reference_width)) {
    out_.view_a = a.index;
    out_.view_b = b.index;
  }

  MatchedPair run(std::vector<ScreenedMatch>* fates) {
    compare();
    if (o_.gms) screen_by_neighbours();
    screen_by_motion();
    for (const auto& m : matches_)
      if (m.fate == MatchFate::kept) out_.kept.push_back(m.match);
    if (static_cast<int>(out_.kept.size()) < o_.min_inliers) out_.kept.clear();
    if (fates != nullptr) *fates = std::move(matches_);
    return std::move(out_);
  }

 private:
  const Feature& of_a(const Match& m) const { return a_.features->features[m.a]; }
  const Feature& of_b(const Match& m) const { return b_.features->features[m.b]; }

  void compare() {
    for (const auto& c : best_candidates(*a_.features, *b_.features)) {
      MatchFate fate = MatchFate::kept;
      if (c.ratio > o_.max_ratio)
        fate = MatchFate::ratio;
      else if (!c.mutual)
        fate = MatchFate::mutual;
      matches_.push_back({c.match, fate});
    }
    drop_repeated();
    out_.candidates = static_cast<int>(left().size());
  }

  // A place with several directions may give the same match more than once.
  void drop_repeated() {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> seen;
    for (auto& m : matches_) {
      if (m.fate != MatchFate::kept) continue;
      seen.emplace_back(of_a(m.match).place, of_b(m.match).place);
    }
    std::ranges::sort(seen);
    for (auto& m : matches_) {
      if (m.fate != MatchFate::kept) continue;
      const std::pair key(of_a(m.match).place, of_b(m.match).place);
      const auto it = std::ranges::lower_bound(seen, key);
      if (it != seen.end() && *it == key)
        seen.erase(it, std::ranges::upper_bound(seen, key));
      else
        m.fate = MatchFate::mutual;
    }
  }

  std::vector<std::size_t> left() const {
    std::vector<std::size_t> out;
    for (std::size_t i = 0; i < matches_.size(); ++i)
      if (matches_[i].fate == MatchFate::kept) out.push_back(i);
    return out;
  }

  void screen_by_neighbours() {
    const auto kept = left();
    if (kept.size() < min_for_statistics) return;
    std::vector<PixelPair> pairs;
    for (const auto i : kept) pairs.push_back({of_a(matches_[i].match).pixel, of_b(matches_[i].match).pixel});
    const auto supported =
        supported_by_neighbours(pairs, {a_.camera->width, a_.camera->height}, {b_.camera->width, b_.camera->height});
    for (std::size_t k = 0; k < kept.size(); ++k)
      if (!supported[k]) matches_[kept[k]].fate = MatchFate::gms;
  }

  bool does_not_move(const Match& m) const { return (of_a(m).pixel - of_b(m).pixel).norm() <= still_px_; }

  std::vector<RayMatch> rays(const std::vector<std::size_t>& which) const {
    std::vector<RayMatch> out;
    for (const auto i : which) {
      const auto &fa = of_a(matches_[i].match), &fb = of_b(matches_[i].match);
      out.push_back({fa.direction, fb.direction, fa.inverse_depth, fb.inverse_depth});
    }
    return out;
  }

  // Whether depth is so rare that it could not decide.
  bool lacks_depth(const std::vector<RayMatch>& matches) const {
    const auto with =
        std::ranges::count_if(matches, [](const auto& m) { return m.inverse_depth_a > 0 || m.inverse_depth_b > 0; });
    return with < 2 * o_.min_inliers;
  }

  MotionOptions motion_options() const {
    const double focal = std::sqrt(std::abs(a_.camera->fx * b_.camera->fx));
    const double scale = std::max(1.0, a_.camera->width / reference_width);
    MotionOptions m;
    m.max_error = o_.max_error_px * scale / focal;
    m.sigma = 0.25 * m.max_error;
    m.inverse_depth_sigma = o_.depth_noise;
    m.min_inliers = o_.min_inliers;
    m.seed = (static_cast<std::uint64_t>(a_.index) << 32) + static_cast<std::uint64_t>(b_.index);
    return m;
  }

  double median_depth(const std::vector<std::size_t>& which) const {
    std::vector<double> z;
    for (const auto i : which)
      if (const double w = of_a(matches_[i].match).inverse_depth; w > 0) z.push_back(1 / w);
    return z.empty() ? 0 : median(std::move(z));
  }

  // Looks for a motion among what moves, and whether what is still belongs to it too.
  void look_for_two_motions(const std::vector<std::size_t>& moving, const std::vector<std::size_t>& still) {
    if (static_cast<int>(std::min(moving.size(), still.size())) < o_.min_inliers) return;
    const auto options = motion_options();
    const auto found = find_motion(rays(moving), options);
    if (!found) return;
    std::vector<double> moved;
    std::vector<std::size_t> movers;
    for (std::size_t k = 0; k < moving.size(); ++k) {
      if (!found->inlier[k]) continue;
      const auto& m = matches_[moving[k]].match;
      moved.push_back((of_a(m).pixel - of_b(m).pixel).norm());
      movers.push_back(moving[k]);
    }
    if (median(std::move(moved)) < min_moving_px) return;
    const auto with_it = agreeing(rays(still), found->T_b_a, options);
    const auto against = std::ranges::count(with_it, 0);
    out_.two_motions = against >= o_.min_inliers &&
                       static_cast<double>(against) >= min_second_share * static_cast<double>(movers.size());
    out_.still_depth = median_depth(still);
    out_.moving_depth = median_depth(movers);
  }

  void screen_by_motion() {
    auto kept = left();
    std::vector<std::size_t> moving, still;
    for (const auto i : kept) (does_not_move(matches_[i].match) ? still : moving).push_back(i);
    out_.still = static_cast<int>(still.size());
    if (o_.drop_still) {
      for (const auto i : still) matches_[i].fate = MatchFate::still;
      kept = moving;
    } else {
      look_for_two_motions(moving, still);
    }
    const auto matches = rays(kept);
    auto found = find_motion(matches, motion_options());
    if (!found && lacks_depth(matches)) {
      found = find_motion_of_rays(matches, motion_options());
      out_.by_rays = found.has_value();
    }
    for (std::size_t k = 0; k < kept.size(); ++k)
      if (!found || !found->inlier[k]) matches_[kept[k]].fate = MatchFate::depth;
    if (found) out_.T_b_a = found->T_b_a;
  }

  MatchableView a_, b_;
  const ScreenOptions& o_;
  double still_px_;
  std::vector<ScreenedMatch> matches_;
  MatchedPair out_;
};

}  // namespace

MatchedPair match_pair(const MatchableView& a, const MatchableView& b, const ScreenOptions& options,
                       std::vector<ScreenedMatch>* fates) {
  return Screening(a, b, options).run(fates);
}

}  // namespace bole::rgbd
