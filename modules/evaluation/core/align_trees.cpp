#include "evaluation/core/align_trees.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace bole::evaluation {
namespace {

constexpr double cell_m = 0.5;
constexpr std::size_t max_trees = 200;

void keep_thickest(std::vector<MapTree>& trees) {
  std::ranges::stable_sort(trees, [](const MapTree& a, const MapTree& b) { return a.dbh_cm > b.dbh_cm; });
  if (trees.size() > max_trees) trees.resize(max_trees);
}

struct Vote {
  std::uint64_t cell;
  Eigen::Vector2d shift;
};

std::uint64_t cell_of(std::int64_t x, std::int64_t y) {
  return (static_cast<std::uint64_t>(y + (1LL << 31)) << 32) | static_cast<std::uint64_t>(x + (1LL << 31));
}

struct Best {
  std::size_t votes = 0;
  double turn = 0;
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();
};

// Cells overlap by half, so that a heap of votes on a border is counted in one of them.
void count_votes(std::vector<Vote>& votes, double turn, Best& best) {
  std::ranges::sort(votes, {}, &Vote::cell);
  for (std::size_t i = 0; i < votes.size();) {
    std::size_t j = i;
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (; j < votes.size() && votes[j].cell == votes[i].cell; ++j) sum += votes[j].shift;
    const auto n = j - i;
    if (n > best.votes || (n == best.votes && std::abs(turn) < std::abs(best.turn)))
      best = {n, turn, sum / static_cast<double>(n)};
    i = j;
  }
}

}  // namespace

Eigen::Isometry2d likeliest_motion(std::vector<MapTree> from, std::vector<MapTree> to, double dbh_gate_cm) {
  Eigen::Isometry2d motion = Eigen::Isometry2d::Identity();
  if (from.empty() || to.empty()) return motion;
  keep_thickest(from);
  keep_thickest(to);
  // About the middle of the trees, so that large coordinates do no harm.
  Eigen::Vector2d middle_from = Eigen::Vector2d::Zero(), middle_to = middle_from;
  for (const auto& t : from) middle_from += t.at / static_cast<double>(from.size());
  for (const auto& t : to) middle_to += t.at / static_cast<double>(to.size());
  Best best;
  std::vector<Vote> votes;
  for (int step = 0; step < 720; ++step) {
    const double turn = (step % 2 == 0 ? step / 2 : -(step + 1) / 2) * std::numbers::pi / 360;
    const Eigen::Rotation2Dd rotation(turn);
    votes.clear();
    for (const auto& a : from) {
      const Eigen::Vector2d p = rotation * (a.at - middle_from);
      for (const auto& b : to) {
        if (dbh_gate_cm > 0 && std::abs(a.dbh_cm - b.dbh_cm) > dbh_gate_cm) continue;
        const Eigen::Vector2d shift = b.at - middle_to - p;
        const auto x = static_cast<std::int64_t>(std::floor(2 * shift.x() / cell_m)),
                   y = static_cast<std::int64_t>(std::floor(2 * shift.y() / cell_m));
        for (int dx = 0; dx < 2; ++dx)
          for (int dy = 0; dy < 2; ++dy) votes.push_back({cell_of(x - dx, y - dy), shift});
      }
    }
    count_votes(votes, turn, best);
  }
  motion.linear() = Eigen::Rotation2Dd(best.turn).toRotationMatrix();
  motion.translation() = middle_to + best.shift - motion.linear() * middle_from;
  return motion;
}

}  // namespace bole::evaluation
