#include "survey/core/choose_targets.h"

#include <fmt/format.h>

#include <cmath>

namespace bole::survey {
namespace {

constexpr double min_distance_m = 2.0;  // nearer pairs are one thing seen twice

double plan_distance(const RetroCluster& a, const RetroCluster& b) { return (a.centre - b.centre).head<2>().norm(); }

bool pair_fits(const RetroCluster& a, const RetroCluster& b, const FrameOptions& o) {
  const double d = plan_distance(a, b);
  return o.target_distance > 0 ? std::abs(d - o.target_distance) <= o.target_tolerance : d >= min_distance_m;
}

struct Pair {
  const RetroCluster *centre = nullptr, *north = nullptr;
  double score = -1;
  std::size_t fitting = 0;  // pairs that would have done
};

// With a known start the centre must be the nearer one of the pair, and near starts count for more than many views.
Pair best_pair(const std::vector<RetroCluster>& candidates, const std::optional<Eigen::Vector3d>& start,
               const FrameOptions& o) {
  Pair best;
  for (const auto& a : candidates)
    for (const auto& b : candidates) {
      if (&a == &b || !pair_fits(a, b, o)) continue;
      double score = std::sqrt(static_cast<double>(a.views) * static_cast<double>(b.views));
      if (start) {
        const double da = (a.centre - *start).head<2>().norm(), db = (b.centre - *start).head<2>().norm();
        if (da > db) continue;
        score /= 1.0 + da;
      } else if (&a > &b) {
        continue;  // sorted by views: the first of the two was seen from more positions
      }
      ++best.fitting;
      if (score > best.score) best.centre = &a, best.north = &b, best.score = score;
    }
  return best;
}

std::string place_text(const RetroCluster& c) {
  return fmt::format("({:.2f}, {:.2f}, {:.2f}) with {} points", c.centre.x(), c.centre.y(), c.centre.z(), c.points);
}

void explain_missing(const std::vector<RetroCluster>& candidates, const FrameOptions& o, TargetChoice& choice) {
  if (candidates.size() >= 2) {
    std::string distances;
    for (std::size_t i = 0; i < candidates.size() && i < 4; ++i)
      for (std::size_t j = i + 1; j < candidates.size() && j < 4; ++j)
        distances +=
            fmt::format("{}{:.2f}", distances.empty() ? "" : ", ", plan_distance(candidates[i], candidates[j]));
    choice.warnings.push_back(
        fmt::format("{} targets were found but no two of them are {} apart (distances: {} m)", candidates.size(),
                    o.target_distance > 0
                        ? fmt::format("{} +- {} m", number_text(o.target_distance), number_text(o.target_tolerance))
                        : fmt::format("{} m or more", number_text(min_distance_m)),
                    distances));
  }
}

}  // namespace

TargetChoice choose_targets(const std::vector<RetroCluster>& candidates,
                            const std::optional<Eigen::Vector3d>& walk_start, const FrameOptions& options) {
  TargetChoice choice;
  if (candidates.empty()) return choice;
  const auto pair = best_pair(candidates, walk_start, options);
  if (!pair.centre) {
    explain_missing(candidates, options, choice);
    const RetroCluster* nearest = &candidates.front();
    if (walk_start)
      for (const auto& c : candidates)
        if ((c.centre - *walk_start).head<2>().norm() < (nearest->centre - *walk_start).head<2>().norm()) nearest = &c;
    choice.targets.push_back({"centre", nearest->centre, nearest->points});
    choice.reason = "only one target: taken for the centre";
    choice.warnings.push_back(
        "one target at " + place_text(*nearest) +
        " gives the origin; the heading of the map was kept, since it takes two targets to tell north");
    return choice;
  }
  choice.targets = {{"centre", pair.centre->centre, pair.centre->points},
                    {"north", pair.north->centre, pair.north->points}};
  choice.reason = walk_start ? "the target nearest to the start of the walk is the centre"
                             : "no trajectory: the target seen from more positions was taken for the centre";
  if (!walk_start)
    choice.warnings.push_back("there is no trajectory to tell which target is the centre: " + place_text(*pair.centre) +
                              ", seen from more positions, was taken for it");
  if (pair.fitting > 1)
    choice.warnings.push_back(
        fmt::format("{} pairs of targets are possible: {} was taken for the centre and {} for the north; "
                    "target_distance would tell",
                    pair.fitting, place_text(*pair.centre), place_text(*pair.north)));
  return choice;
}

}  // namespace bole::survey
