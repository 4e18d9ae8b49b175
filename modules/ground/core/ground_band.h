// The height of the ground within a thin neighbourhood of points.
#pragma once

#include <span>

namespace bole::ground {

// A point near the middle of a neighbourhood: plan offsets from the middle and height above a rough surface, metres.
struct BandPoint {
  float dx, dy, height;
};

struct BandFit {
  double height = 0;  // of the ground at the middle, above the rough surface, metres
  double sigma = 0;   // scatter of the ground points, metres
};

// Robust plane through the lowest strong layer of the points (see fit_terrain). At least one point; with fewer than six
// the median height. `half_band_m`: heights lie within +- this.
BandFit fit_ground_band(std::span<const BandPoint> points, double half_band_m);

}  // namespace bole::ground
