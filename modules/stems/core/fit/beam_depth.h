// How deep a beam of finite width measures a round stem.
#pragma once

namespace bole::stems {

// Of a section of radius 1: the distance of the measured range in front of the plane through the axis across the beam.
struct LitDepth {
  double depth = 0;
  double by_impact2 = 0, by_width = 0;  // derivatives
};

inline constexpr double max_lit_impact2 = 1.6, max_lit_width = 0.6;

// `impact2`: squared distance of the middle of the beam from the axis; `width`: standard deviation of the light across
// the beam; both in radii, beyond the limits above taken at the limits. The range is the mean over the part of a normal
// beam that meets the stem, weighted by the cosine of incidence (Lambert): a beam half beside the stem still measures
// its edge, and a wide one lights the flat middle more than the steep flank. A beam without width is a ray.
LitDepth lit_depth(double impact2, double width);

}  // namespace bole::stems
