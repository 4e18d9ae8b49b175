#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"
#include "base/statistics.h"
#include "survey/core/georeference/plan_fit.h"
#include "survey/core/georeference/track_fit.h"
#include "survey/core/path_clock.h"
#include "survey/core/path_curve.h"

namespace bole::survey {
namespace {

constexpr double step_s = 0.5, max_gap_s = 1;
constexpr std::size_t max_fixes = 300, min_fixes = 20;

struct Trial {
  double offset_s = 0;
  double misfit_m = std::numeric_limits<double>::infinity();
  double overlap_s = 0;
};

class OffsetSearch {
 public:
  OffsetSearch(const Trajectory& walk, const std::vector<TrackFix>& track) : curve_(walk, max_gap_s), track_(track) {}

  double begin_s() const { return curve_.begin_s() - track_.back().time_s; }
  double end_s() const { return curve_.end_s() - track_.front().time_s; }
  double shorter_s() const {
    return std::min(curve_.end_s() - curve_.begin_s(), track_.back().time_s - track_.front().time_s);
  }
  double overlap_s(double offset) const {
    return std::min(curve_.end_s(), track_.back().time_s + offset) -
           std::max(curve_.begin_s(), track_.front().time_s + offset);
  }

  // Median distance after turn and shift, in which half of the fixes may be wrong.
  Trial attempt(double offset) const {
    Trial trial{offset};
    trial.overlap_s = overlap_s(offset);
    if (trial.overlap_s < 0.5 * shorter_s()) return trial;
    const auto first = std::ranges::lower_bound(track_, curve_.begin_s() - offset, {}, &TrackFix::time_s),
               last = std::ranges::upper_bound(track_, curve_.end_s() - offset, {}, &TrackFix::time_s);
    const auto count = static_cast<std::size_t>(last - first);
    if (count < min_fixes) return trial;
    const std::size_t stride = (count + max_fixes - 1) / max_fixes;
    std::vector<PlanPair> pairs;
    for (auto fix = first; fix < last;
         fix += static_cast<std::ptrdiff_t>(std::min<std::size_t>(stride, static_cast<std::size_t>(last - fix))))
      if (const auto place = curve_.at(fix->time_s + offset))
        pairs.push_back({place->head<2>(), fix->global.head<2>(), 1});
    if (pairs.size() < min_fixes) return trial;
    trial.misfit_m = robust_misfit_m(pairs);
    return trial;
  }

 private:
  static double robust_misfit_m(std::vector<PlanPair>& pairs) {
    double middle = 0;
    constexpr int rounds = 3;
    for (int k = 0; k < rounds; ++k) {
      const auto fit = fit_plan(pairs);
      std::vector<double> distances;
      for (const auto& r : fit.residuals) distances.push_back(r.norm());
      middle = median(distances);
      const double scale = std::max(middle, 1e-3);
      for (std::size_t i = 0; i < pairs.size(); ++i)
        pairs[i].sd_m = std::sqrt(1 + distances[i] * distances[i] / (scale * scale));
    }
    return middle;
  }

  const PathCurve curve_;
  const std::vector<TrackFix>& track_;
};

void try_range(const OffsetSearch& search, double from, double to, std::vector<Trial>& trials) {
  for (double offset = from; offset <= to; offset += step_s)
    if (const auto trial = search.attempt(offset); std::isfinite(trial.misfit_m)) trials.push_back(trial);
}

ClockOffsetFound best_of(const std::vector<Trial>& trials, const std::string& times) {
  constexpr double apart_s = 20, alike = 1.3, negligible_m = 0.05, as_long = 0.8;
  const double smallest_misfit_m = std::ranges::min_element(trials, {}, &Trial::misfit_m)->misfit_m;
  const auto fits = [](const Trial& t, double misfit_m) { return t.misfit_m <= alike * misfit_m + negligible_m; };
  double longest_s = 0;
  for (const auto& t : trials)
    if (fits(t, smallest_misfit_m)) longest_s = std::max(longest_s, t.overlap_s);
  Trial best;
  for (const auto& t : trials)
    if (t.overlap_s >= as_long * longest_s && t.misfit_m < best.misfit_m) best = t;
  ClockOffsetFound found{best.offset_s, best.misfit_m};
  for (const auto& t : trials) {
    if (std::abs(t.offset_s - best.offset_s) <= apart_s || !fits(t, best.misfit_m)) continue;
    if (t.overlap_s >= as_long * longest_s)
      throw bad_input(times + fmt::format(": with {:.1f} s and with {:.1f} s between the clocks the track fits alike "
                                          "(median distance {:.2f} and {:.2f} m)",
                                          best.offset_s, t.offset_s, best.misfit_m, t.misfit_m),
                      "a walk whose shape tells the time", "Set clock_offset and a small clock_window");
    found.rival_s = t.offset_s;
  }
  return found;
}

}  // namespace

std::vector<double> usual_clock_offsets(const Trajectory& walk, const std::vector<TrackFix>& track) {
  const double walk_begin = walk.poses.front().time_s, track_begin = track.front().time_s;
  std::vector<double> offsets;
  for (const auto& o : possible_offsets({walk_begin, walk.poses.back().time_s}, {track_begin, track.back().time_s}))
    offsets.push_back(o.offset_s);
  // A receiver without the date sends the time of day.
  constexpr double day_s = 86400, earliest_date_s = 1e8;
  if (track_begin < 2 * day_s && walk_begin > earliest_date_s)
    offsets.push_back(std::floor(walk_begin / day_s) * day_s);
  return offsets;
}

ClockOffsetFound find_clock_offset(const Trajectory& walk, const std::vector<TrackFix>& track,
                                   const std::vector<double>& candidates_s, double window_s) {
  if (walk.poses.size() < 2 || track.size() < min_fixes)
    throw bad_input(fmt::format("the walk has {} poses, the track {} fixes", walk.poses.size(), track.size()),
                    fmt::format("at least 2 and {}", min_fixes));
  const OffsetSearch search(walk, track);
  std::vector<Trial> trials;
  for (const double c : candidates_s) try_range(search, c - window_s, c + window_s, trials);
  constexpr double longest_search_s = 200'000;
  if (trials.empty() && search.end_s() - search.begin_s() < longest_search_s)
    try_range(search, search.begin_s(), search.end_s(), trials);
  const std::string times =
      fmt::format("the times of the walk go from {:.1f} to {:.1f} s, those of the track from {:.1f} to {:.1f} s",
                  walk.poses.front().time_s, walk.poses.back().time_s, track.front().time_s, track.back().time_s);
  if (trials.empty())
    throw bad_input(times + ": no offset of the clocks brings half of the shorter one over the other",
                    "a track that was recorded during the walk", "Set clock_offset, or check that both are of one day");
  return best_of(trials, times);
}

}  // namespace bole::survey
