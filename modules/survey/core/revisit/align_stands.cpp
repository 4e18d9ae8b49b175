#include "survey/core/revisit/align_stands.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "base/angles.h"
#include "base/statistics.h"
#include "survey/core/revisit/motion_votes.h"
#include "survey/core/revisit/stand_hull.h"

namespace bole::survey {
namespace {

constexpr double place_sigma_m = 0.15, dbh_sigma_cm = 1.5, miss_log = 1.9;  // 15 % of the trees may be missed
constexpr double min_evidence = 30, rival_margin = 12, min_share = 0.35;
constexpr std::size_t min_pairs = 5;
constexpr double rival_turn = radians(3), rival_shift_m = 0.7;  // nearer motions are the same

Eigen::Vector2d middle_of(const std::vector<StandTree>& trees) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const auto& t : trees) sum += t.at;
  return sum / std::max<double>(1, static_cast<double>(trees.size()));
}

std::vector<StandTree> about(std::vector<StandTree> trees, const Eigen::Vector2d& middle) {
  for (auto& t : trees) t.at -= middle;
  return trees;
}

// Least squares with Tukey's weights over the pairs.
Eigen::Isometry2d fitted(const std::vector<StandTree>& first, const std::vector<StandTree>& second,
                         const std::vector<TreePair>& pairs, double cut_m) {
  double sum = 0;
  Eigen::Vector2d middle_first = Eigen::Vector2d::Zero(), middle_second = middle_first;
  const auto weight = [&](const TreePair& p) {
    const double u = std::min(1.0, p.distance_m / cut_m);
    return std::pow(1 - u * u, 2) + 1e-9;
  };
  for (const auto& p : pairs) {
    middle_first += weight(p) * first[p.first].at;
    middle_second += weight(p) * second[p.second].at;
    sum += weight(p);
  }
  middle_first /= sum;
  middle_second /= sum;
  double along = 0, across = 0;
  for (const auto& p : pairs) {
    const Eigen::Vector2d a = first[p.first].at - middle_first, b = second[p.second].at - middle_second;
    along += weight(p) * b.dot(a);
    across += weight(p) * (b.x() * a.y() - b.y() * a.x());
  }
  const double turn = std::atan2(across, along);
  return motion_of(turn, middle_first - Eigen::Rotation2Dd(turn) * middle_second);
}

struct Stand {
  const std::vector<StandTree>& trees;
  StandHull hull;
  double spread_cm = 1;  // of its diameters
  explicit Stand(const std::vector<StandTree>& all) : trees(all), hull(places(all)) {
    std::vector<double> dbh;
    for (const auto& t : all)
      if (std::isfinite(t.dbh_cm)) dbh.push_back(t.dbh_cm);
    if (dbh.size() < 3) return;
    const double middle = median(dbh);
    for (double& d : dbh) d = std::abs(d - middle);
    spread_cm = std::max(1.0, 1.4826 * median(dbh));
  }
  static std::vector<Eigen::Vector2d> places(const std::vector<StandTree>& all) {
    std::vector<Eigen::Vector2d> at;
    for (const auto& t : all) at.push_back(t.at);
    return at;
  }
};

// Trees of both maps that lie in the area of the other: those that could have a partner.
std::size_t trees_in_common(const Stand& a, const Stand& b, const Eigen::Isometry2d& T) {
  const Eigen::Isometry2d back = T.inverse();
  const auto in_b = std::ranges::count_if(a.trees, [&](const StandTree& t) { return b.hull.contains(back * t.at, 0); });
  const auto in_a = std::ranges::count_if(b.trees, [&](const StandTree& t) { return a.hull.contains(T * t.at, 0); });
  return static_cast<std::size_t>(std::min(in_a, in_b));
}

void score(const Stand& a, const Stand& b, StandAlignment& s) {
  std::vector<double> growth;
  for (const auto& p : s.pairs)
    if (const double g = b.trees[p.second].dbh_cm - a.trees[p.first].dbh_cm; std::isfinite(g)) growth.push_back(g);
  const double usual = growth.empty() ? 0 : median(growth);
  const double density = static_cast<double>(b.trees.size()) / std::max(10.0, b.hull.area_m2());
  const double place = -std::log(2 * std::numbers::pi * place_sigma_m * place_sigma_m * density);
  const double spread = std::hypot(a.spread_cm, b.spread_cm), thick = std::log(std::max(1.0, spread / dbh_sigma_cm));
  double squared = 0;
  s.evidence = 0;
  for (const auto& p : s.pairs) {
    squared += p.distance_m * p.distance_m;
    s.evidence += place - std::pow(p.distance_m / place_sigma_m, 2) / 2;
    const double g = b.trees[p.second].dbh_cm - a.trees[p.first].dbh_cm - usual;
    if (!std::isfinite(g)) continue;
    constexpr double max_loss = 4;  // one diameter that went wrong does not speak against the whole
    s.evidence += std::max(-max_loss, thick - std::pow(g / dbh_sigma_cm, 2) / 2 + std::pow(g / spread, 2) / 2);
  }
  s.rms_m = s.pairs.empty() ? 0 : std::sqrt(squared / static_cast<double>(s.pairs.size()));
  const auto common = trees_in_common(a, b, s.T_first_second);
  if (common > s.pairs.size()) s.evidence -= miss_log * static_cast<double>(common - s.pairs.size());
}

StandAlignment refined(const Stand& a, const Stand& b, Eigen::Isometry2d T, const AlignLimits& limits) {
  StandAlignment s;
  for (const double reach : {2.0, 1.5, 1.0, 1.0, 1.0, 1.0}) {
    AlignLimits near = limits;
    near.match_distance_m = reach * limits.match_distance_m;
    const auto pairs = match_trees(a.trees, b.trees, T, near);
    if (pairs.size() < 2) break;
    T = fitted(a.trees, b.trees, pairs, near.match_distance_m);
  }
  s.T_first_second = T;
  s.pairs = match_trees(a.trees, b.trees, T, limits);
  score(a, b, s);
  return s;
}

void judge(const Stand& a, const Stand& b, StandAlignment& best) {
  const auto common = trees_in_common(a, b, best.T_first_second);
  const auto n = static_cast<double>(best.pairs.size());
  const bool enough =
      best.pairs.size() >= min_pairs && best.evidence >= min_evidence && n >= min_share * static_cast<double>(common);
  const bool many = static_cast<double>(best.rival_pairs) >= 0.7 * n;
  const bool as_good =
      best.rival_pairs > 0 && best.rival_evidence / static_cast<double>(best.rival_pairs) > best.evidence / n - 1;
  best.certain = enough && best.evidence - best.rival_evidence > rival_margin && !(many && as_good);
}

StandAlignment moved_back(StandAlignment s, const Eigen::Vector2d& middle_first, const Eigen::Vector2d& middle_second) {
  s.T_first_second.translation() += middle_first - s.T_first_second.linear() * middle_second;
  return s;
}

}  // namespace

std::vector<TreePair> match_trees(const std::vector<StandTree>& first, const std::vector<StandTree>& second,
                                  const Eigen::Isometry2d& T, const AlignLimits& limits) {
  std::vector<TreePair> offered;
  for (std::size_t j = 0; j < second.size(); ++j) {
    const Eigen::Vector2d p = T * second[j].at;
    for (std::size_t i = 0; i < first.size(); ++i)
      if (const double d = (first[i].at - p).norm();
          d <= limits.match_distance_m && may_be_same(first[i], second[j], limits))
        offered.push_back({i, j, d});
  }
  std::ranges::stable_sort(offered, {}, &TreePair::distance_m);
  std::vector<std::uint8_t> first_taken(first.size(), 0), second_taken(second.size(), 0);
  std::vector<TreePair> pairs;
  for (const auto& p : offered) {
    if (first_taken[p.first] != 0 || second_taken[p.second] != 0) continue;
    first_taken[p.first] = second_taken[p.second] = 1;
    pairs.push_back(p);
  }
  std::ranges::sort(pairs, {}, &TreePair::first);
  return pairs;
}

StandAlignment align_stands(const std::vector<StandTree>& first, const std::vector<StandTree>& second,
                            const AlignLimits& limits, const Run& run) {
  const Eigen::Vector2d middle_first = middle_of(first), middle_second = middle_of(second);
  const auto a = about(first, middle_first), b = about(second, middle_second);
  const Stand stand_a(a), stand_b(b);
  StandAlignment best;
  std::vector<StandAlignment> all;
  for (const auto& candidate : likely_motions(a, b, limits, run)) {
    run.check_cancel();
    all.push_back(refined(stand_a, stand_b, candidate, limits));
  }
  std::ranges::stable_sort(all, std::ranges::greater{}, &StandAlignment::evidence);
  if (all.empty()) return best;
  best = all.front();
  for (const auto& other : all)
    if (!same_motion(other.T_first_second, best.T_first_second, rival_turn, rival_shift_m)) {
      best.rival_evidence = std::max(0.0, other.evidence);
      best.rival_pairs = other.pairs.size();
      break;
    }
  judge(stand_a, stand_b, best);
  return moved_back(std::move(best), middle_first, middle_second);
}

StandAlignment align_in_place(const std::vector<StandTree>& first, const std::vector<StandTree>& second,
                              const AlignLimits& limits) {
  const Eigen::Vector2d middle = middle_of(first);
  const auto a = about(first, middle), b = about(second, middle);
  const Stand stand_a(a), stand_b(b);
  auto best = refined(stand_a, stand_b, Eigen::Isometry2d::Identity(), limits);
  judge(stand_a, stand_b, best);
  return moved_back(std::move(best), middle, middle);
}

}  // namespace bole::survey
