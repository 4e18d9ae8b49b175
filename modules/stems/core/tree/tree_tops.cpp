#include "stems/core/tree/tree_tops.h"

#include <fmt/format.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/statistics.h"
#include "cloud/core/whole/whole_cloud.h"
#include "stems/core/tree/tree_axis.h"
#include "stems/core/tree/tree_ends.h"

namespace bole::stems {
namespace {

constexpr double bin_m = 0.5, widest_empty_m = 3, tip_m = 1.0;
constexpr double bare_stem_m = 5;  // what is lower is a stem without its crown
constexpr double beyond_m = 1.5;   // above a top the sensor must reach this far
// A straight edge of the cloud through the top leaves half of its surroundings empty, in cells a little less.
constexpr double max_empty_beside = 0.4;
constexpr double beside_m = 1.0;    // what is so near the top and higher reaches over it ...
constexpr double overhang_m = 0.3;  // ... by more than this
constexpr std::uint32_t min_bin_points = 3, min_tip_points = 8;
// Lead of the own way to the top over that of the next tree. On simulated stands heights of trees with less are off by
// metres, those with more by half a metre, whether something reaches over them or not.
constexpr double min_lead_m = 0.6, min_overtopped_lead_m = 0.8;
constexpr double max_off_axis_m = 2, max_off_axis_share = 0.10;  // of the height; beyond it the top is a neighbour's
constexpr int min_views = 50;

// The highest point of every square of the plot.
class CanopyTop {
 public:
  CanopyTop(const PointCloud& points, const Run& run) {
    constexpr double max_cells = 1 << 24;
    Eigen::Vector2f low = Eigen::Vector2f::Constant(std::numeric_limits<float>::infinity()), high = -low;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if ((i & 0xfffffU) == 0) run.check_cancel();
      if (const auto& p = points.positions()[i]; p.allFinite()) {
        low = low.cwiseMin(p.head<2>());
        high = high.cwiseMax(p.head<2>());
      }
    }
    if (!(low.array() <= high.array()).all()) return;
    corner_ = aligned_corner(low.cast<double>(), grid_anchor(points, run).head<2>(), static_cast<double>(cell_))
                  .cast<float>();
    const Eigen::Vector2f extent = high - corner_;
    while ((std::floor(extent.x() / cell_) + 1) * (std::floor(extent.y() / cell_) + 1) > max_cells) cell_ *= 2;
    nx_ = static_cast<int>(extent.x() / cell_) + 1;
    ny_ = static_cast<int>(extent.y() / cell_) + 1;
    highest_.assign(static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_), nothing);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if ((i & 0xfffffU) == 0) run.check_cancel();
      const auto& p = points.positions()[i];
      if (!p.allFinite()) continue;
      auto& top = highest_[index(static_cast<int>((p.x() - corner_.x()) / cell_),
                                 static_cast<int>((p.y() - corner_.y()) / cell_))];
      top = std::max(top, p.z());
    }
  }

  // Calls f(highest z, -infinity for none) for the squares whose middle lies within a distance of a place, also for
  // those beyond the cloud.
  template <class F>
  void around(const Eigen::Vector2d& place, double outer_m, F&& f) const {
    const Eigen::Vector2d q = (place - corner_.cast<double>()) / cell_;
    const double reach = outer_m / cell_;
    for (int iy = static_cast<int>(std::floor(q.y() - reach)); iy <= static_cast<int>(std::ceil(q.y() + reach)); ++iy)
      for (int ix = static_cast<int>(std::floor(q.x() - reach)); ix <= static_cast<int>(std::ceil(q.x() + reach)); ++ix)
        if (cell_ * std::hypot(ix + 0.5 - q.x(), iy + 0.5 - q.y()) <= outer_m)
          f(ix >= 0 && iy >= 0 && ix < nx_ && iy < ny_ ? highest_[index(ix, iy)] : nothing);
  }
  double highest(const Eigen::Vector2d& place, double outer_m) const {
    float z = nothing;
    around(place, outer_m, [&](float top) { z = std::max(z, top); });
    return z;
  }
  double empty_share(const Eigen::Vector2d& place, double outer_m) const {
    int all = 0, empty = 0;
    around(place, outer_m, [&](float top) {
      ++all;
      empty += top == nothing;
    });
    return all > 0 ? static_cast<double>(empty) / all : 1;
  }

 private:
  static constexpr float nothing = -std::numeric_limits<float>::infinity();
  std::size_t index(int ix, int iy) const {
    return static_cast<std::size_t>(iy) * static_cast<std::size_t>(nx_) + static_cast<std::size_t>(ix);
  }
  Eigen::Vector2f corner_ = Eigen::Vector2f::Zero();
  float cell_ = 0.5F;
  int nx_ = 0, ny_ = 0;
  std::vector<float> highest_;
};

struct Top {
  double height_m = 0;                                      // above the stem's ground
  double own_m = 0;                                         // likewise, of points that no other tree can claim
  Eigen::Vector2d at = Eigen::Vector2d::Zero();             // of the highest point
  std::uint32_t tip_points = 0;                             // within tip_m below it
  double lead_m = std::numeric_limits<double>::infinity();  // median over the tip
  bool by_hand = false;                                     // a person gave the tree points there
};

// Index of the stem by tree id; -1 for none.
std::vector<int> stems_by_id(const std::vector<Stem>& stems) {
  std::int32_t largest = 0;
  for (const auto& s : stems) largest = std::max(largest, s.id);
  std::vector<int> by_id(static_cast<std::size_t>(largest) + 1, -1);
  for (std::size_t k = 0; k < stems.size(); ++k) by_id[static_cast<std::size_t>(stems[k].id)] = static_cast<int>(k);
  return by_id;
}

// Calls f(stem index, point index, height above the stem's ground) for all labelled points.
template <class F>
void for_each_labelled(const std::vector<Stem>& stems, const PointCloud& points, const PointLabels& labels,
                       const Run& run, F&& f) {
  const auto by_id = stems_by_id(stems);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if ((i & 0xfffffU) == 0) run.check_cancel();
    if (labels.tree_id[i] == 0) continue;
    const int k = by_id[static_cast<std::size_t>(labels.tree_id[i])];
    const double h = static_cast<double>(points.positions()[i].z()) - stems[static_cast<std::size_t>(k)].ground_z;
    if (h >= 0 && h < tallest_m) f(static_cast<std::size_t>(k), i, h);
  }
}

// Whether a point stands above its stem: tops do, whatever the crown reaches out to.
bool over_stem(const Stem& s, const Eigen::Vector3d& p, double height_m) {
  const Eigen::Vector2d beside = p.head<2>() - TreeAxis(s).at(p.z());
  return beside.norm() <= s.radius + std::max(max_off_axis_m, max_off_axis_share * height_m);
}

struct Bin {
  std::uint32_t points = 0;
  double highest = 0;
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  bool by_hand = false;

  void add(double h, const Eigen::Vector3f& p, bool given) {
    ++points;
    by_hand = by_hand || given;
    if (h <= highest) return;
    highest = h;
    at = p.head<2>().cast<double>();
  }
};
using Bins = std::vector<Bin>;

// The highest bin that holds enough, upwards until a gap that no tree has, unless a person gave the tree what is above
// it; null where none does.
const Bin* top_bin(const Bins& bins) {
  const Bin* top = nullptr;
  double gap = 0;
  for (const auto& bin : bins) {
    if (bin.points < min_bin_points) {
      gap += bin_m;
    } else if (top == nullptr || gap <= widest_empty_m || bin.by_hand) {
      top = &bin;
      gap = 0;
    } else {
      gap = std::numeric_limits<double>::infinity();  // what lies higher is no part of it either
    }
  }
  return top;
}

std::vector<Top> find_tops(const std::vector<Stem>& stems, const PointCloud& points, const PointLabels& labels,
                           const CrownGrowth& growth, const Run& run) {
  const Bins empty(static_cast<std::size_t>(tallest_m / bin_m));
  std::vector<Bins> all(stems.size(), empty), own(stems.size(), empty);
  for_each_labelled(stems, points, labels, run, [&](std::size_t k, std::size_t i, double h) {
    const auto bin = static_cast<std::size_t>(h / bin_m);
    const bool given = !growth.by_hand.empty() && growth.by_hand[i] != 0;
    all[k][bin].add(h, points.positions()[i], given);
    if (given ||
        (!(growth.lead_m[i] < min_overtopped_lead_m) && over_stem(stems[k], points.positions()[i].cast<double>(), h)))
      own[k][bin].add(h, points.positions()[i], given);
  });
  std::vector<Top> tops(stems.size());
  for (std::size_t k = 0; k < stems.size(); ++k) {
    if (const auto* top = top_bin(all[k])) {
      tops[k].height_m = top->highest;
      tops[k].at = top->at;
      tops[k].by_hand = top->by_hand;
    }
    if (const auto* top = top_bin(own[k])) tops[k].own_m = top->highest;
  }
  std::vector<std::vector<double>> leads(stems.size());
  for_each_labelled(stems, points, labels, run, [&](std::size_t k, std::size_t i, double h) {
    if (h > tops[k].height_m || h < tops[k].height_m - tip_m) return;
    ++tops[k].tip_points;
    if (!std::isnan(growth.lead_m[i])) leads[k].push_back(growth.lead_m[i]);
  });
  for (std::size_t k = 0; k < stems.size(); ++k)
    if (!leads[k].empty()) tops[k].lead_m = upper_median(leads[k]);
  return tops;
}

// How far up and how far away the sensor measures: of returns from trees, so that the many on the ground do not count.
struct SensorReach {
  double steepest = 0;  // tangent of the elevation
  double longest_m = 0;
  bool covers(const Eigen::Vector3d& from, const Eigen::Vector3d& to) const {
    const Eigen::Vector3d ray = to - from;
    return ray.norm() < longest_m && ray.z() < steepest * std::max(0.01, ray.head<2>().norm());
  }
};

// Share `rank` of the values lie below; 0 for none.
double quantile(std::vector<double>& values, double rank) {
  if (values.empty()) return 0;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(rank * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, at);
  return *at;
}

SensorReach sensor_reach(const PointCloud& points, const PointLabels& labels, const SensorOf& sensor_of,
                         const Run& run) {
  std::vector<double> steepness, ranges;
  for (std::size_t k = 0, i = 0; i < points.size(); ++k, i += 7) {
    if ((k & 0x1ffffU) == 0) run.check_cancel();
    if (labels.tree_id[i] == 0) continue;
    const auto sensor = sensor_of(i);
    if (!sensor) continue;
    const Eigen::Vector3d ray = (points.positions()[i] - *sensor).cast<double>();
    steepness.push_back(ray.z() / std::max(0.01, ray.head<2>().norm()));
    ranges.push_back(ray.norm());
  }
  // A jerk of the hand tilts the sensor for a moment; that is not how far it sees.
  return {quantile(steepness, 0.98), quantile(ranges, 0.999)};
}

// Whether the sensor would have measured a return beyond_m above the top from enough of the places that it saw the tree
// from (crowns in between may still hide more).
std::vector<char> tops_in_reach(const std::vector<Stem>& stems, const std::vector<Top>& tops, const PointCloud& points,
                                const PointLabels& labels, const SensorOf& sensor_of, const Run& run) {
  std::vector<char> in_reach(stems.size(), 1);
  if (!sensor_of) return in_reach;
  const SensorReach reach = sensor_reach(points, labels, sensor_of, run);
  std::vector<int> views(stems.size(), 0);
  for_each_labelled(stems, points, labels, run, [&](std::size_t k, std::size_t i, double) {
    if (views[k] >= min_views) return;
    const auto sensor = sensor_of(i);
    if (!sensor) return;
    const Eigen::Vector3d above_top(tops[k].at.x(), tops[k].at.y(), stems[k].ground_z + tops[k].height_m + beyond_m);
    views[k] += reach.covers(sensor->template cast<double>(), above_top) ? 1 : 0;
  });
  for (std::size_t k = 0; k < stems.size(); ++k) in_reach[k] = views[k] >= min_views;
  return in_reach;
}

TopVerdict verdict_of(const Stem& s, const Top& top, const CanopyTop& canopy, bool in_reach, TreeEnd end) {
  const double z = s.ground_z + top.height_m;
  if (top.height_m < bare_stem_m) return TopVerdict::low;
  if (!in_reach) return TopVerdict::out_of_reach;
  if (canopy.empty_share(top.at, beside_m) > max_empty_beside) return TopVerdict::at_edge;
  if (!top.by_hand && !over_stem(s, {top.at.x(), top.at.y(), z}, top.height_m)) return TopVerdict::off_axis;
  if (top.lead_m < min_overtopped_lead_m && canopy.highest(top.at, beside_m) > z + overhang_m)
    return TopVerdict::overtopped;
  if (top.lead_m < min_lead_m) return TopVerdict::contested;
  if (top.tip_points < min_tip_points) return TopVerdict::sparse;
  if (end == TreeEnd::cloud_edge) return TopVerdict::cut_off;
  if (end != TreeEnd::narrows && !top.by_hand) return TopVerdict::no_tip;
  return TopVerdict::seen;
}

// Only what no other tree can claim bounds the height from below.
bool may_be_anothers(TopVerdict verdict) {
  return verdict == TopVerdict::off_axis || verdict == TopVerdict::overtopped || verdict == TopVerdict::contested;
}

void report_cut(const std::vector<TopVerdict>& verdicts, const std::optional<CloudCut>& cut, double origin_z,
                Report& report) {
  const auto ended = std::ranges::count(verdicts, TopVerdict::cut_off);
  report.counts["trees_cut_off"] = ended;
  if (ended == 0) return;
  const auto trees = fmt::format("the cloud ends at the highest points of {} of {} trees", ended, verdicts.size());
  const std::string then = "their heights are lower bounds, without volume. Give the cloud with its tops";
  if (!cut)
    report.find(
        Severity::note, "cloud_ends_below_tops",
        fmt::format("{}, where the stems around them are still thick: {}, or scan from further away", trees, then));
  else if (cut->level)
    report.find(Severity::look, "cloud_ends_below_tops",
                fmt::format("{}: it was cut at z = {:.1f} m; {}", trees, origin_z + cut->z_m, then));
  else
    report.find(Severity::look, "cloud_ends_below_tops",
                fmt::format("{}: it was cut {:.1f} m above the ground; {}", trees, cut->z_m, then));
}

}  // namespace

std::vector<TopVerdict> measure_tops(std::vector<Stem>& stems, const PointCloud& points, const PointLabels& labels,
                                     const CrownGrowth& growth, const SensorOf& sensor_of, const Run& run,
                                     Report& report) {
  std::vector<TopVerdict> verdicts;
  if (stems.empty()) return verdicts;
  std::vector<Top> tops;
  std::vector<char> in_reach;
  std::vector<double> heights;
  TreeEnds ends;
  std::optional<CanopyTop> canopy;
  std::optional<LowEnds> low_ends;
  tbb::parallel_invoke(
      [&] {
        tops = find_tops(stems, points, labels, growth, run);
        for (const auto& top : tops) heights.push_back(top.height_m);
        ends = tree_ends(stems, heights, points, labels, run);
        in_reach = tops_in_reach(stems, tops, points, labels, sensor_of, run);
      },
      [&] {
        canopy.emplace(points, run);
        low_ends.emplace(stems, points, run);
      });
  low_ends->judge(stems, heights);
  for (std::size_t k = 0; k < stems.size(); ++k) {
    auto& s = stems[k];
    verdicts.push_back(verdict_of(s, tops[k], *canopy, in_reach[k] != 0, ends.by_stem[k]));
    s.height_m = may_be_anothers(verdicts.back()) ? tops[k].own_m : tops[k].height_m;
    s.height_seen = verdicts.back() == TopVerdict::seen;
  }
  report.counts["tops_seen"] = std::ranges::count(verdicts, TopVerdict::seen);
  report_cut(verdicts, ends.cut, points.origin.z(), report);
  return verdicts;
}

}  // namespace bole::stems
