#include "survey/core/revisit/motion_votes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>

#include "base/angles.h"

namespace bole::survey {
namespace {

constexpr std::size_t max_trees = 200, max_candidates = 60;
constexpr double min_pair_m = 4, max_pair_m = 80, pair_slack_m = 0.15;
constexpr double turn_cell = radians(2), shift_cell_m = 1;

std::vector<StandTree> thickest(std::vector<StandTree> trees) {
  std::ranges::stable_sort(trees, [](const StandTree& a, const StandTree& b) {
    return (std::isfinite(a.dbh_cm) ? a.dbh_cm : 0) > (std::isfinite(b.dbh_cm) ? b.dbh_cm : 0);
  });
  if (trees.size() > max_trees) trees.resize(max_trees);
  return trees;
}

struct Link {
  double length = 0;
  std::uint32_t from = 0, to = 0;
};

// Both directions of every pair, by length.
std::vector<Link> links_of(const std::vector<StandTree>& trees, bool both_ways) {
  std::vector<Link> links;
  for (std::uint32_t i = 0; i < trees.size(); ++i)
    for (std::uint32_t j = both_ways ? 0 : i + 1; j < trees.size(); ++j) {
      const double length = (trees[i].at - trees[j].at).norm();
      if (i != j && length >= min_pair_m && length <= max_pair_m) links.push_back({length, i, j});
    }
  std::ranges::stable_sort(links, {}, &Link::length);
  return links;
}

struct Vote {
  double turn = 0;
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();
};

// A motion for every pair of links of like length whose trees may be the same; the shift is that of the middle of the
// first map, so that an error of the turn moves it little.
std::vector<Vote> votes_of(const std::vector<StandTree>& first, const std::vector<StandTree>& second,
                           const AlignLimits& limits, const Run& run) {
  constexpr std::size_t max_votes = 1'500'000;
  const auto a = links_of(first, false), b = links_of(second, true);
  std::vector<Vote> votes;
  std::size_t begin = 0;
  for (const auto& link : a) {
    run.check_cancel();
    while (begin < b.size() && b[begin].length < link.length - pair_slack_m) ++begin;
    const Eigen::Vector2d d = first[link.to].at - first[link.from].at;
    for (std::size_t k = begin; k < b.size() && b[k].length <= link.length + pair_slack_m; ++k) {
      const auto &p = second[b[k].from], &q = second[b[k].to];
      if (!may_be_same(first[link.from], p, limits) || !may_be_same(first[link.to], q, limits)) continue;
      const Eigen::Vector2d e = q.at - p.at;
      const double turn = std::atan2(e.x() * d.y() - e.y() * d.x(), e.dot(d));
      const Eigen::Vector2d shift =
          (first[link.from].at + first[link.to].at) / 2 - Eigen::Rotation2Dd(turn) * ((p.at + q.at) / 2);
      votes.push_back({turn, shift});
      if (votes.size() == max_votes) return votes;
    }
  }
  return votes;
}

// Cell of a grid that is displaced by half a cell along the directions of the bits of `grid`.
std::uint64_t cell_of(const Vote& v, unsigned grid) {
  constexpr double half = 1 << 19;
  const auto part = [&](double value, unsigned bit) {
    const double cell = std::floor(value + ((grid >> bit & 1U) != 0 ? 0.5 : 0.0)) + half;
    return static_cast<std::uint64_t>(std::clamp(cell, 0.0, 2 * half - 1));
  };
  return part(v.turn / turn_cell, 0) << 40 | part(v.shift.y() / shift_cell_m, 1) << 20 |
         part(v.shift.x() / shift_cell_m, 2);
}

struct Heap {
  std::size_t votes = 0;
  Eigen::Isometry2d motion = Eigen::Isometry2d::Identity();
};

// The means of the cells of one grid, the fullest first.
std::vector<Heap> heaps_of(const std::vector<Vote>& votes, unsigned grid) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> sorted;
  sorted.reserve(votes.size());
  for (std::size_t i = 0; i < votes.size(); ++i)
    sorted.emplace_back(cell_of(votes[i], grid), static_cast<std::uint32_t>(i));
  std::ranges::sort(sorted);
  std::vector<Heap> heaps;
  for (std::size_t i = 0; i < sorted.size();) {
    std::size_t j = i;
    Vote sum;
    for (; j < sorted.size() && sorted[j].first == sorted[i].first; ++j) {
      sum.turn += votes[sorted[j].second].turn;
      sum.shift += votes[sorted[j].second].shift;
    }
    const auto n = static_cast<double>(j - i);
    heaps.push_back({j - i, motion_of(sum.turn / n, sum.shift / n)});
    i = j;
  }
  std::ranges::stable_sort(heaps, std::ranges::greater{}, &Heap::votes);
  if (heaps.size() > max_candidates) heaps.resize(max_candidates);
  return heaps;
}

// The fullest cells of eight grids, so that no heap of votes is lost because it lies on a border; each motion once.
std::vector<Eigen::Isometry2d> candidates_of(const std::vector<Vote>& votes) {
  constexpr unsigned grids = 8;
  std::vector<Heap> all;
  for (unsigned grid = 0; grid < grids; ++grid) std::ranges::move(heaps_of(votes, grid), std::back_inserter(all));
  std::ranges::stable_sort(all, std::ranges::greater{}, &Heap::votes);
  std::vector<Eigen::Isometry2d> out;
  for (const auto& heap : all) {
    if (out.size() == max_candidates) break;
    const bool known = std::ranges::any_of(
        out, [&](const auto& other) { return same_motion(heap.motion, other, turn_cell / 2, shift_cell_m / 2); });
    if (!known) out.push_back(heap.motion);
  }
  return out;
}

}  // namespace

bool may_be_same(const StandTree& a, const StandTree& b, const AlignLimits& limits) {
  const double growth = b.dbh_cm - a.dbh_cm;
  return !(growth < -limits.max_loss_cm || growth > limits.max_growth_cm);  // unknown diameters go with all
}

Eigen::Isometry2d motion_of(double turn, const Eigen::Vector2d& shift) {
  Eigen::Isometry2d T = Eigen::Isometry2d::Identity();
  T.linear() = Eigen::Rotation2Dd(turn).toRotationMatrix();
  T.translation() = shift;
  return T;
}

double turn_of(const Eigen::Isometry2d& T) { return std::atan2(T.linear()(1, 0), T.linear()(0, 0)); }

bool same_motion(const Eigen::Isometry2d& a, const Eigen::Isometry2d& b, double turn_rad, double shift_m) {
  return std::abs(wrapped(turn_of(a) - turn_of(b))) < turn_rad && (a.translation() - b.translation()).norm() < shift_m;
}

std::vector<Eigen::Isometry2d> likely_motions(const std::vector<StandTree>& first, const std::vector<StandTree>& second,
                                              const AlignLimits& limits, const Run& run) {
  return candidates_of(votes_of(thickest(first), thickest(second), limits, run));
}

}  // namespace bole::survey
