#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/statistics.h"
#include "cloud/known_facts.h"
#include "survey/core/check/judge_map.h"

namespace bole::survey {
namespace {

constexpr std::size_t min_cells = 10, min_stems = 4;

struct Measured {
  Eigen::Vector2d at;
  double value_cm = 0;
};

std::vector<double> values_of(const std::vector<Measured>& all) {
  std::vector<double> values;
  for (const auto& m : all) values.push_back(m.value_cm);
  return values;
}

Eigen::Vector2d worst_of(const std::vector<Measured>& all) {
  return std::ranges::max_element(all, {}, &Measured::value_cm)->at;
}

double share_above_pct(const std::vector<Measured>& all, double limit_cm) {
  const auto n = std::ranges::count_if(all, [&](const Measured& m) { return m.value_cm > limit_cm; });
  return all.empty() ? 0 : 100 * static_cast<double>(n) / static_cast<double>(all.size());
}

// `what` do not meet: the median, or a fifth of the plot above twice the limit.
void judge_spread(const char* code, const std::string& what, const std::vector<Measured>& all, const CheckOptions& o,
                  CheckFindings& out) {
  constexpr double part_pct = 20;
  const double usual = median(values_of(all));
  const double part = share_above_pct(all, 2 * o.max_pass_spread_cm);
  if (usual <= o.max_pass_spread_cm && part <= part_pct) return;
  out.add(usual > o.walk_again_spread_cm || share_above_pct(all, o.walk_again_spread_cm) > part_pct ? Severity::refused
                                                                                                    : Severity::look,
          code,
          fmt::format("{} of two passes lie {:.1f} cm apart (median of {} places), more than {:.1f} cm in {:.0f} % of "
                      "them: passes do not meet. Look for a loop closure that slipped, and run slam again without it",
                      what, usual, all.size(), 2 * o.max_pass_spread_cm, part),
          worst_of(all));
}

bool alike(double a_cm, double b_cm) { return std::abs(a_cm - b_cm) < 1 + 0.15 * std::max(a_cm, b_cm); }

bool disjoint(const std::set<std::int32_t>& a, const std::set<std::int32_t>& b) {
  return std::ranges::none_of(a, [&](auto pass) { return b.contains(pass); });
}

struct Ghost {
  Eigen::Vector2d at, shift;
};

// Pairs of stems of like diameter that are seen by different passes, or stand nearer than stems do where passes are
// not known.
std::vector<Ghost> possible_ghosts(const std::vector<StemMeasure>& stems, bool passes) {
  constexpr double reach_m = 2.5, reach_without_passes_m = 0.8;
  std::vector<Ghost> ghosts;
  for (std::size_t i = 0; i < stems.size(); ++i)
    for (std::size_t j = 0; j < stems.size(); ++j) {
      const auto &a = stems[i], &b = stems[j];
      if (i == j || !alike(a.dbh_cm, b.dbh_cm)) continue;
      const Eigen::Vector2d d = b.at - a.at;
      if (d.norm() > (passes ? reach_m : reach_without_passes_m)) continue;
      if (passes && (a.passes.empty() || b.passes.empty() || !disjoint(a.passes, b.passes))) continue;
      if (passes ? *a.passes.begin() < *b.passes.begin() : i < j) ghosts.push_back({a.at, d});
    }
  return ghosts;
}

// A stand that is mapped twice has the same shift between the two stems of every tree.
void judge_doubled(const CheckedMap& map, CheckFindings& out) {
  constexpr double alike_m = 0.12;
  constexpr std::size_t min_pairs = 4;
  constexpr double min_share = 0.15;
  const auto ghosts = possible_ghosts(map.stems, map.grid.has_passes);
  std::size_t best = 0;
  const Ghost* at = nullptr;
  for (const auto& g : ghosts) {
    const auto n = static_cast<std::size_t>(std::ranges::count_if(ghosts, [&](const Ghost& other) {
      return std::min((other.shift - g.shift).norm(), (other.shift + g.shift).norm()) < alike_m;
    }));
    if (n > best) best = n, at = &g;
  }
  if (best < min_pairs || static_cast<double>(best) < min_share * static_cast<double>(map.stems.size())) return;
  out.add(
      Severity::refused, "stand_doubled",
      fmt::format("{} pairs of stems of like diameter stand {:.2f} m apart in the same direction: parts of the walk "
                  "were mapped beside each other, and trees stand there twice. Run slam again, or walk again",
                  best, at->shift.norm()),
      at->at);
}

void judge_walls(const CheckedMap& map, CheckFindings& out) {
  std::vector<Measured> walls;
  for (const auto& s : map.stems)
    if (std::isfinite(s.wall_cm)) walls.push_back({s.at, s.wall_cm});
  if (walls.size() < min_stems) return out.skip("walls", "fewer than 4 stems have enough points on their bark");
  // A sensor cannot show walls thinner than its own noise.
  constexpr double cm_of_noise = 150;
  const double noise_m = fact_number(map.in.points->facts, facts::range_noise).value_or(0);
  const double usual = median(values_of(walls)), limit = std::max(map.options.max_wall_cm, cm_of_noise * noise_m);
  map.report.metrics["wall"] = {usual, Unit::centimetre};
  constexpr double thick = 1.5, part_pct = 25;
  const double part = share_above_pct(walls, thick * limit);
  if (usual <= limit && part <= part_pct) return;
  out.add(usual > 2 * limit ? Severity::refused : Severity::look, "walls_thick",
          fmt::format("the points scatter by {:.1f} cm about the bark (median of {} stems; {:.0f} % above {:.1f} cm): "
                      "walls are doubled or blurred. Diameters allow for an even blur, not for doubled walls: look at "
                      "sections of some stems, and measure these in the field",
                      usual, walls.size(), part, thick * limit),
          worst_of(walls));
}

}  // namespace

void judge_sharpness(const CheckedMap& map, CheckFindings& out) {
  if (map.in.points != nullptr && map.grid.has_heights) judge_walls(map, out);
  judge_doubled(map, out);
  if (!map.grid.has_passes) return out.skip("passes", "the cloud does not tell passes apart (no pass, no time)");
  std::vector<Measured> ground, stems;
  for (std::size_t i = 0; i < map.grid.cells.size(); ++i)
    if (const auto& c = map.grid.cells[i]; c.inside && std::isfinite(c.pass_spread_cm))
      ground.push_back({map.grid.middle(i), c.pass_spread_cm});
  for (const auto& s : map.stems)
    if (std::isfinite(s.pass_spread_cm)) stems.push_back({s.at, s.pass_spread_cm});
  if (ground.size() >= min_cells) {
    map.report.metrics["ground_pass_spread"] = {median(values_of(ground)), Unit::centimetre};
    judge_spread("ground_passes_apart", "the ground", ground, map.options, out);
  }
  if (stems.size() >= min_stems) {
    map.report.metrics["stem_pass_spread"] = {median(values_of(stems)), Unit::centimetre};
    judge_spread("stem_passes_apart", "stems", stems, map.options, out);
  }
  if (ground.size() < min_cells && stems.size() < min_stems)
    out.skip("passes", "hardly any place was seen in two passes");
}

}  // namespace bole::survey
