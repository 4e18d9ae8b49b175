// A tapered, bowed cylinder fitted to the edges of the stem in all views.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/run.h"
#include "plant/core/traits/stem_strips.h"

namespace bole::plant {

struct StemFit {
  StemCurve axis;
  double diameter = 0;        // at axis.height
  double taper = 0;           // change of the diameter per unit of height
  double standard_error = 0;  // of the diameter, from the scatter over the views
  double freedom = 1;         // degrees of it
  double view_scatter = 0;    // standard deviation of the views' diameters
  double residual_px = 0;     // of the edges
  std::size_t views = 0, strips = 0;
  // Per view: its own diameter at the height, and its weight.
  struct PerView {
    std::uint32_t view = 0;
    double diameter = 0, weight = 0;
    std::size_t strips = 0;
  };
  std::vector<PerView> per_view;
};

// The edges are tangents: the planes through the camera and the edges touch the cylinder, so that the distance of the
// axis from each is the radius. Axis, radius and taper are found by robust least squares (Tukey), with a small shift
// per view for the errors of its pose. Sets the weights of the strips. Nothing where fewer than three views or twelve
// strips agree.
std::optional<StemFit> fit_stem(std::vector<StemStrip>& strips, const StemCurve& start, double start_radius,
                                double pose_sigma_px, const Run& run);

}  // namespace bole::plant
