// How deep a beam of finite width, from a place that is not quite known, measures a round stem.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace bole::stems {

// Of a section of radius 1: the distance of the measured range in front of the plane through the axis across the beam.
struct LitDepth {
  double depth = 0;
  double by_impact2 = 0, by_width = 0;  // derivatives
};

inline constexpr double max_lit_impact2 = 1.6, max_lit_width = 0.6;

// Depth by width, then by impact squared.
namespace depth_grid {
inline constexpr int impact_steps = 320, width_steps = 60;
inline constexpr double impact_step = max_lit_impact2 / impact_steps, width_step = max_lit_width / width_steps,
                        by_impact_step = 1 / impact_step, by_width_step = 1 / width_step;
}  // namespace depth_grid
const std::vector<double>& depth_table();            // of a beam
const std::vector<double>& scattered_depth_table();  // of rays

// `impact2`: squared distance of the middle of the beam from the axis; `width`: standard deviation of the light across
// the beam; both in radii, beyond the limits above taken at the limits. The range is the mean over the part of a normal
// beam that meets the stem, weighted by the cosine of incidence (Lambert): a beam half beside the stem still measures
// its edge, and a wide one lights the flat middle more than the steep flank. A beam without width is a ray.
// `scattered`: share of the width squared that comes from where the beam is not known rather than from its light. Thin
// rays that scatter so and meet the stem all return, whatever their incidence.
class BeamDepth {
 public:
  LitDepth operator()(double impact2, double width, double scattered = 0) const;

 private:
  static LitDepth look_up(const double* table, double q, double w);
  const double *table_ = depth_table().data(), *scattered_table_ = scattered_depth_table().data();
};
inline LitDepth lit_depth(double impact2, double width, double scattered = 0) {
  return BeamDepth()(impact2, width, scattered);
}

inline double ray_depth(double impact2) { return std::sqrt(std::max(0.0, 1 - impact2)); }

inline LitDepth BeamDepth::look_up(const double* table, double q, double w) {
  using namespace depth_grid;
  const auto iq = static_cast<int>(q), iw = static_cast<int>(w);
  const double fq = q - iq, fw = w - iw;
  const double *low = table + iw * (impact_steps + 1) + iq, *high = low + impact_steps + 1;
  const double by_low = low[1] - low[0], by_high = high[1] - high[0];
  const double a = low[0] + fq * by_low, b = high[0] + fq * by_high;
  return {a + fw * (b - a), ((1 - fw) * by_low + fw * by_high) * by_impact_step, (b - a) * by_width_step};
}

inline LitDepth BeamDepth::operator()(double impact2, double width, double scattered) const {
  using namespace depth_grid;
  if (width <= 0) {
    const double depth = ray_depth(impact2);
    return {depth, depth > 0 ? -0.5 / depth : 0, 0};
  }
  const double q = std::clamp(impact2 * by_impact_step, 0.0, impact_steps - 1e-9),
               w = std::min(width * by_width_step, width_steps - 1e-9);
  const LitDepth beam = look_up(table_, q, w);
  if (scattered <= 0) return beam;
  const LitDepth rays = look_up(scattered_table_, q, w);
  const auto mixed = [scattered](double a, double b) { return a + scattered * (b - a); };
  return {mixed(beam.depth, rays.depth), mixed(beam.by_impact2, rays.by_impact2), mixed(beam.by_width, rays.by_width)};
}

}  // namespace bole::stems
