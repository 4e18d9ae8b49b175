// Diameters along a whole stem from its cloud, whose excess is known at one height.
#pragma once

#include <vector>

#include "plant/core/leaves/axis_curve.h"

namespace bole::plant {

// A diameter that was measured without bias.
struct KnownDiameter {
  double along = 0;  // arc of the stem
  double value = 0, sd = 0;
};

struct StemTaper {
  std::vector<double> along, diameter, sd;  // from the soil to the tip; empty where the cloud does not tell
  double volume = 0, volume_low = 0, volume_high = 0;
};

// Radii of a cloud are too large: by fattened depth the same everywhere, by noise the more the thinner the stem. What
// the cloud reads too much at the known place is taken off in both ways; the mean is the diameter, and half the
// difference goes into its standard deviation. A smooth curve goes through the radii, petioles above it. `step`:
// between places.
StemTaper stem_taper(const AxisCurve& stem, const KnownDiameter& known, double step);

}  // namespace bole::plant
