#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/groups.h"
#include "base/statistics.h"
#include "survey/core/check/judge_map.h"
#include "survey/core/plot_options.h"
#include "survey/core/revisit/stand_hull.h"

namespace bole::survey {
namespace {

using Chosen = std::vector<std::uint8_t>;

struct Patch {
  double area_m2 = 0;
  Eigen::Vector2d at = Eigen::Vector2d::Zero();  // the cell of it that lies nearest to its middle
};

// The largest connected group of chosen cells (by edges).
Patch largest_patch(const CheckGrid& grid, const Chosen& chosen) {
  const auto nx = static_cast<std::size_t>(grid.nx);
  Groups groups(grid.cells.size());
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    if (chosen[i] == 0) continue;
    if (i % nx + 1 < nx && chosen[i + 1] != 0) groups.join(i, i + 1);
    if (i + nx < chosen.size() && chosen[i + nx] != 0) groups.join(i, i + nx);
  }
  std::vector<std::size_t> size(chosen.size(), 0);
  std::size_t best = 0;
  for (std::size_t i = 0; i < chosen.size(); ++i)
    if (chosen[i] != 0) ++size[groups.root(i)];
  for (std::size_t i = 0; i < size.size(); ++i)
    if (size[i] > size[best]) best = i;
  Patch patch;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < chosen.size(); ++i)
    if (chosen[i] != 0 && groups.root(i) == best) sum += grid.middle(i);
  const Eigen::Vector2d middle = sum / std::max<double>(1, static_cast<double>(size[best]));
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < chosen.size(); ++i)
    if (chosen[i] != 0 && groups.root(i) == best)
      if (const double d = (grid.middle(i) - middle).norm(); d < nearest) {
        nearest = d;
        patch.at = grid.middle(i);
      }
  patch.area_m2 = static_cast<double>(size[best]) * grid.cell_m * grid.cell_m;
  return patch;
}

class Cover {
 public:
  Cover(const CheckedMap& map, CheckFindings& findings)
      : map_(map), grid_(map.grid), o_(map.options), out_(findings), inside_(map.grid.inside_cells()) {}

  void judge() {
    if (map_.in.points == nullptr) out_.skip("ground, density and directions of view", "there is no cloud");
    if (inside_ == 0) return out_.skip("cover", "no cell lies in the plot");
    judge_walk();
    if (map_.in.points == nullptr) return;
    if (grid_.has_heights) {
      judge_ground();
      judge_density();
    } else {
      out_.skip("ground seen", "the points have no heights above the ground");
    }
    if (grid_.has_views)
      judge_views();
    else
      out_.skip("directions of view", "the cloud does not know from where its points were seen");
  }

 private:
  template <class Test>
  Chosen choose(Test test) const {
    Chosen chosen(grid_.cells.size(), 0);
    for (std::size_t i = 0; i < chosen.size(); ++i) chosen[i] = grid_.cells[i].inside && test(grid_.cells[i]);
    return chosen;
  }
  double share_pct(const Chosen& chosen) const {
    return 100 * static_cast<double>(std::ranges::count(chosen, 1)) / static_cast<double>(inside_);
  }
  template <class Value>
  std::vector<double> values(Value value) const {
    std::vector<double> all;
    for (const auto& c : grid_.cells)
      if (const double v = c.inside ? static_cast<double>(value(c)) : std::nan(""); std::isfinite(v)) all.push_back(v);
    return all;
  }

  void judge_ground() {
    const auto needed = static_cast<std::uint32_t>(o_.min_ground_points);
    const auto unseen = choose([&](const CheckCell& c) { return c.ground_points < needed; });
    const auto empty = choose([](const CheckCell& c) { return c.points == 0; });
    const double share = share_pct(unseen);
    const auto hole = largest_patch(grid_, unseen);
    map_.report.metrics["ground_unseen"] = {share, Unit::percent};
    map_.report.metrics["largest_hole"] = {hole.area_m2, Unit::square_metre};
    const bool again = share > o_.walk_again_unseen_pct && grid_.bounded;
    if (share <= o_.max_unseen_pct && hole.area_m2 <= o_.max_hole_m2) return;
    // survey.plot reports a plot that is mostly empty by this code; it is the same matter.
    constexpr double mostly_empty_pct = 10;
    const bool same = share_pct(empty) > mostly_empty_pct;
    out_.add(again ? Severity::refused : Severity::look, same ? "plot_partly_empty" : "ground_never_seen",
             fmt::format("{}the ground of {:.1f} % of the {} was never seen ({:.1f} % hold no point at all); the "
                         "largest hole has {:.0f} m2. Terrain, heights and stems are guesses there",
                         map_.in.plot != nullptr ? assumed_size_remedy(*map_.in.plot) : std::string(), share,
                         grid_.bounded ? "plot" : "surveyed area", share_pct(empty), hole.area_m2),
             hole.at);
  }

  void judge_density() {
    auto density = values([](const CheckCell& c) { return c.ground_points; });
    const double usual = median(density);
    map_.report.metrics["ground_points_per_cell"] = {usual, Unit::none};
    const auto needed = static_cast<std::uint32_t>(o_.min_ground_points);
    const auto sparse = choose([&](const CheckCell& c) {
      return c.ground_points >= needed && c.ground_points < o_.min_density_pct / 100 * usual;
    });
    const double share = share_pct(sparse);
    map_.report.metrics["sparse_cells"] = {share, Unit::percent};
    if (share > o_.max_one_sided_pct)
      out_.add(
          Severity::look, "ground_sparse",
          fmt::format("{:.0f} % of the plot have fewer ground points than {:.0f} % of the usual {:.0f} per cell of "
                      "{:.2g} m: seen from afar or through leaves only",
                      share, o_.min_density_pct, usual, grid_.cell_m),
          largest_patch(grid_, sparse).at);
  }

  void judge_views() {
    const auto one_sided =
        choose([&](const CheckCell& c) { return c.points > 0 && c.view_span_deg < o_.min_view_span_deg; });
    const double share = share_pct(one_sided);
    map_.report.metrics["one_sided"] = {share, Unit::percent};
    map_.report.metrics["view_directions"] = {median(values([](const CheckCell& c) { return c.directions; })),
                                              Unit::none};
    if (share > o_.max_one_sided_pct)
      out_.add(Severity::look, "seen_from_one_side",
               fmt::format("{:.0f} % of the plot were seen from one side only (directions of view within {:.0f} deg): "
                           "diameters there rest on one side of the stems",
                           share, o_.min_view_span_deg),
               largest_patch(grid_, one_sided).at);
  }

  // The area within the walk. A gap between two lanes lies in it; the rim of the plot does not, and is walked less
  // closely in every plot.
  StandHull walked_area() const {
    std::vector<Eigen::Vector2d> places;
    for (const auto& pose : map_.in.trajectory->poses)
      places.emplace_back(pose.T_target_sensor.translation().head<2>());
    return StandHull(std::move(places));
  }

  // A walk in lanes has half their distance as its greatest distance to any place. Where most of the plot was walked
  // more closely than one part of it, a lane is missing there.
  void judge_walk() {
    auto distances = values([](const CheckCell& c) { return c.walk_m; });
    if (distances.empty()) return out_.skip("places that were not walked", "there is no trajectory");
    if (!grid_.bounded) return out_.skip("places that were not walked", "the plot has no boundary");
    std::ranges::sort(distances);
    const double three_quarters = distances[distances.size() * 3 / 4], farthest = distances.back();
    map_.report.metrics["farthest_from_walk"] = {farthest, Unit::metre};
    constexpr double uneven = 1.4, within = 0.75, min_share_pct = 2, large_share_pct = 10;
    const double limit = std::max(o_.max_walk_gap, uneven * three_quarters),
                 limit_within = std::max(within * o_.max_walk_gap, uneven * three_quarters);
    const auto area = walked_area();
    Chosen far(grid_.cells.size(), 0);
    for (std::size_t i = 0; i < far.size(); ++i)
      far[i] =
          grid_.cells[i].inside && grid_.cells[i].walk_m > (area.contains(grid_.middle(i), 0) ? limit_within : limit);
    if (share_pct(far) < min_share_pct) return;
    out_.add(share_pct(far) > large_share_pct ? Severity::refused : Severity::look, "lane_not_walked",
             fmt::format("{:.0f} % of the plot lie farther from the walk than {:.1f} m ({:.1f} m at the rim), up to "
                         "{:.1f} m, while three quarters of it lie within {:.1f} m: a lane was left out. Walk it",
                         share_pct(far), limit_within, limit, farthest, three_quarters),
             largest_patch(grid_, far).at);
  }

  const CheckedMap& map_;
  const CheckGrid& grid_;
  const CheckOptions& o_;
  CheckFindings& out_;
  std::size_t inside_;
};

}  // namespace

void judge_cover(const CheckedMap& map, CheckFindings& findings) { Cover(map, findings).judge(); }

}  // namespace bole::survey
