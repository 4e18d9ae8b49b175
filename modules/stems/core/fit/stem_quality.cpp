#include "stems/core/fit/stem_quality.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/angles.h"

namespace bole::stems {
namespace {
constexpr int max_doubts = 4;                                // a fit with as many is no stem
constexpr int enough_per_section = 15, few_per_section = 6;  // points on the bark
constexpr double max_widening = 0.02;                        // of the radius per metre: 4 cm of diameter
constexpr double widest_gap_m = 0.45;  // between used sections, that breast height may lie in unmarked

// Seen from one side, points tell taper and radius apart by little: of 869 stems of simulated stands 11 were fitted so,
// and three of them lay outside their interval.
constexpr double seen_in_part_deg = 300, max_narrowing_cm_per_m = 6;
bool usual_narrowing(double cm_per_m) { return cm_per_m >= -0.8 && cm_per_m <= max_narrowing_cm_per_m; }

// Seen all round, it narrows so: a flare of the roots, a buttress, or a bank that the terrain runs below (a spruce at
// the edge of a terrace was measured 1.6 m too low and 4.5 cm too thick). Thick trees flare more.
bool flares(double cm_per_m, double radius_m) {
  constexpr double share_per_m = 0.15;  // of the diameter
  return cm_per_m > std::max(max_narrowing_cm_per_m, 200 * radius_m * share_per_m);
}

// Heights of the nearest used sections below and above.
std::pair<double, double> sections_beside(const Stem& s, double height) {
  double below = s.lowest, above = s.highest;
  for (const auto& m : s.sections) {
    if (!m.used) continue;
    if (m.height <= height) below = std::max(below, m.height);
    if (m.height >= height) above = std::min(above, m.height);
  }
  return {below, above};
}

// Many sections, seen nearly all round, that stop the rays: a stem stands here however blurred the map of it is. Leaves
// let rays through.
bool certainly_stands(const Stem& s) {
  return s.sections_used >= 5 && s.arc_rad * deg_per_rad >= 200 && s.ray_through <= 0.15;
}
}  // namespace

void judge(Stem& s, double breast_height_m) {
  s.reasons.clear();
  int doubts = 0, blurs = 0;  // whether it is a stem; how well its bark is mapped
  int sparse = 0;             // how little is known of its diameter
  const auto fault = [&](int weight, Reason why) { doubts += weight, s.reasons.push_back(std::move(why)); };
  const auto blur = [&](int weight, Reason why) { blurs += weight, s.reasons.push_back(std::move(why)); };
  // Poses that scatter say nothing against a stem.
  const double poses_cm = 200 * s.poses_m, half_cm = 200 * (s.radius_high - s.lobes_m - s.radius) - poses_cm,
               arc_deg = s.arc_rad * deg_per_rad;
  const bool beam_matters = 200 * s.edges_m > std::max(1.0, 8 * s.radius);
  if (arc_deg < 150)
    fault(arc_deg < 100 ? 2 : 1, {StemReason::short_arc, {arc_deg}});
  else if (!s.rays_known && arc_deg < 200)
    fault(1, {StemReason::arc_without_rays, {arc_deg}});
  else if (!s.rays_known && beam_matters)
    s.reasons.push_back({StemReason::arc_without_rays, {arc_deg}});
  const Reason wide(StemReason::wide_interval, {100 * (s.radius_high - s.radius_low)});
  if (half_cm > std::max(1.0, 16 * s.radius))
    blur(half_cm > std::max(2.0, 32 * s.radius) ? 2 : 1, wide);
  else if (half_cm + poses_cm > std::max(1.0, 8 * s.radius) || beam_matters) {  // no reason to give the stem up
    sparse += half_cm + poses_cm > std::max(1.0, 16 * s.radius) ? 2 : 1;
    s.reasons.push_back(wide);
  }
  if (const int each = s.inliers / std::max(1, s.sections_used);
      s.inliers < points_for_a_diameter || each < enough_per_section) {
    sparse += s.inliers < points_for_a_diameter || each < few_per_section ? 2 : 1;
    s.reasons.push_back({StemReason::few_points, {static_cast<double>(s.inliers), static_cast<double>(each)}});
  }
  if (s.lowest > breast_height_m + 0.15 || s.highest < breast_height_m - 0.15)
    fault(2, {StemReason::extrapolated, {s.lowest, s.highest}});
  else if (const auto [below, above] = sections_beside(s, breast_height_m); above - below > widest_gap_m)
    fault(1, {StemReason::interpolated, {below, above}});
  else if (s.sections_used < 5)
    fault(1, {StemReason::few_sections, {static_cast<double>(s.sections_used)}});
  if (s.inside_share > 0.10) blur(s.inside_share > 0.25 ? 2 : 1, {StemReason::points_inside, {100 * s.inside_share}});
  if (s.contrary_arc_rad > 0) blur(1, {StemReason::arc_inside, {s.contrary_arc_rad * deg_per_rad}});
  if (s.contrast < 6) blur(s.contrast < 3 ? 2 : 1, {StemReason::low_contrast, {s.contrast}});
  if (s.sigma_m > 0.02) blur(s.sigma_m > 0.03 ? 2 : 1, {StemReason::rough_bark, {100 * s.sigma_m}});
  if (s.lobes_m > 0) ++sparse, s.reasons.push_back({StemReason::not_round, {100 * s.noise_m, 200 * s.lobes_m}});
  if (s.pass_spread_m > 0.05) blur(1, {StemReason::passes_disagree, {100 * s.pass_spread_m}});
  if (const double narrowing = -200 * s.taper; arc_deg <= seen_in_part_deg && !usual_narrowing(narrowing))
    sparse += 2, s.reasons.push_back({StemReason::odd_taper, {arc_deg, narrowing}});
  else if (flares(narrowing, s.radius))
    sparse += 2, s.reasons.push_back({StemReason::flares, {narrowing}});
  if (s.taper > 0.01) blur(1, {StemReason::wider_above});
  if (s.ray_through > 0.1) fault(s.ray_through > 0.2 ? 2 : 1, {StemReason::rays_through, {100 * s.ray_through}});
  if (const double lean = std::acos(std::min(1.0, s.direction.z())) * deg_per_rad; lean > 15)
    s.reasons.push_back({StemReason::leaning, {lean}});
  s.doubts = certainly_stands(s) ? doubts : doubts + blurs;
  // Only at a fork does a stem widen upward like this: somebody should look, but it need not go.
  const int faults = doubts + blurs + sparse + (s.taper > max_widening ? 1 : 0);
  s.quality = faults == 0 ? "good" : faults == 1 ? "fair" : "poor";
  s.state = faults >= 2 ? "check" : "auto";
}

std::optional<std::string> objection(const Stem& s, const MeasureOptions& options) {
  if (s.ray_through > options.max_ray_through)
    return fmt::format("{:.0f} % of the rays towards its core pass through; bark lets none (limit {:.0f} %)",
                       100 * s.ray_through, 100 * options.max_ray_through);
  if (200 * s.radius < options.min_dbh_cm)
    return fmt::format("{:.1f} cm thick, below min_dbh of {:.1f} cm", 200 * s.radius, options.min_dbh_cm);
  if (200 * s.radius > options.max_dbh_cm)
    return fmt::format("{:.1f} cm thick, above max_dbh of {:.1f} cm", 200 * s.radius, options.max_dbh_cm);
  if (s.arc_rad * deg_per_rad < options.min_arc_deg)
    return fmt::format("only {:.0f} deg of a circle seen, min_arc is {:.0f} deg", s.arc_rad * deg_per_rad,
                       options.min_arc_deg);
  if (s.unbroken_arc_rad * deg_per_rad < options.min_arc_deg)
    return fmt::format(
        "separate clumps, not bark: no part of the circle longer than {:.0f} deg is without a gap (min_arc is {:.0f} "
        "deg)",
        s.unbroken_arc_rad * deg_per_rad, options.min_arc_deg);
  if (s.inside_share > 0.5)
    return fmt::format("{:.0f} % of its points lie inside the circle: not a surface", 100 * s.inside_share);
  if (s.doubts >= max_doubts) return "too doubtful: " + joined(s.reasons);
  if (2 * (s.radius_high - s.lobes_m - s.poses_m - s.radius) > 1.2 * s.radius)
    return fmt::format("the diameter is uncertain by more than half of it ({:.0f} to {:.0f} cm)", 200 * s.radius_low,
                       200 * s.radius_high);
  return std::nullopt;
}

}  // namespace bole::stems
