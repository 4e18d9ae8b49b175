// Which views are matched with which: neighbours in time, views that look alike, views that see the same by their
// poses.
#pragma once

#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "base/report.h"
#include "base/run.h"
#include "rgbd/core/poses/view_data.h"

namespace bole::rgbd {

// Collects matched pairs; every pair is tried once. Deterministic at any number of threads.
class ViewMatcher {
 public:
  ViewMatcher(const std::vector<ViewData>& data, const PoseOptions& options, double depth_noise);

  void match_neighbours(const Run& run);
  // By the features alone. Of long series every n-th view takes part.
  void match_alike(const Run& run);
  // By the overlap that the poses predict.
  void match_overlapping(const std::vector<std::optional<Pose>>& poses, const Run& run);

  // Whether most pairs of neighbours show two motions; then everything is matched again without what stands still,
  // unless what stands still is the object.
  void settle_turntable(const Run& run, Report& report);

  // Every pair that was tried, by views.
  const std::vector<MatchedPair>& pairs() const { return pairs_; }
  MatchedPair match(int a, int b, std::vector<ScreenedMatch>* fates) const;
  int loops() const { return loops_; }  // connected pairs that are no neighbours

 private:
  using Pairs = std::vector<std::pair<int, int>>;
  void match_all(const Pairs& wanted, const Run& run, const char* what);
  bool board_moves() const;
  // For each view up to `count` partners with the largest score, not closer to one another than the neighbours reach.
  Pairs best_partners(const std::vector<std::vector<double>>& score, const std::vector<int>& views, int count) const;

  const std::vector<ViewData>& data_;
  const PoseOptions& o_;
  ScreenOptions screen_;
  std::vector<MatchedPair> pairs_;
  std::set<std::pair<int, int>> tried_;
  int loops_ = 0;
};

}  // namespace bole::rgbd
